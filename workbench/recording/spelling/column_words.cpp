#include "workbench/recording/spelling/column_words.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/spelling/cell_number.hpp"
#include "workbench/recording/spelling/quality_words.hpp"

namespace workbench {
namespace {

// Whole names, letters without case and marks: English, German, French, Spanish, Italian,
// Portuguese, Dutch, Swedish, Norwegian, Danish, Finnish, Polish, Czech, Slovak,
// Hungarian, Romanian, Turkish, Russian, Japanese, Chinese, Korean.
constexpr auto kPartWords = std::to_array<std::pair<Part, std::string_view>>({
    {Part::kTime,
     "t|time|timestamp|date|datetime|zeit|datum|zeitstempel|uhrzeit|datumzeit|"
     "datumuhrzeit|timestring|ts|utc|localtime|utctime|sampletime|recordtime|trendtime|"
     "elapsed|elapsedtime|seconds|sekunden|microseconds|microsec|micros|usec|tstamp|"
     "eventtime|clock|xvalue|horodatage|temps|heure|fecha|hora|tiempo|ora|tempo|tijd|"
     "datumtijd|czas|dataiczas|dataczas|znacznikczasu|cas|datumacas|zaman|tarih|saat|"
     "tarihsaat|tarihvesaat|zamandamgasi|datahora|dataehora|fechahora|fechayhora|"
     "marcadetiempo|dataora|dataeora|dateheure|dateetheure|tijdstip|datumentijd|"
     "tijdstempel|tid|dato|tidpunkt|tidspunkt|klokkeslett|tidsstaempel|datotid|"
     "datumtid|tidsstempel|aika|aikaleima|kellonaika|paeivaemaeaerae|pvm|paeivaeys|ido|"
     "idopont|idobelyeg|timp|datasiora|время|дата|датаивремя|датавремя|меткавремени|"
     "時間|時刻|日時|日付|日付時刻|タイムスタンプ|时间|日期|日期时间|时间戳|采样时间|"
     "记录时间|日期時間|시간|시각|날짜|일시|일자|datenum|timegenerated"},
    {Part::kU,
     "u|op|out|co|cv|cveu|output|controlleroutput|controloutput|controlsignal|lmn|"
     "ausgang|reglerausgang|stellgroesse|stellwert|stellsignal|outval|mvout|sortie|"
     "sortieregulateur|commande|salida|uscita|uitgang|regelaaruitgang|wyjscie|"
     "wyjscieregulatora|sygnalsterujacy|sterowanie|wielkoscsterujaca|wielkoscnastawcza|"
     "vystup|vystupregulatoru|akcnizasah|akcnivelicina|akcnyzasah|cikis|kontrolcikisi|"
     "cikisdegeri|kontroloercikisi|saida|saidadocontrolador|saidadecontrole|"
     "saidacontrole|variavelmanipulada|sinaldecontrole|salidadelcontrolador|"
     "salidacontrolador|salidadecontrol|variablemanipulada|uscitaregolatore|"
     "uscitadelregolatore|uscitacontrollore|comando|variabilemanipolata|"
     "sortieduregulateur|commandevanne|grandeurreglante|signaldecommande|stellgrad|"
     "reglerausgangswert|uitsturing|stuursignaal|regeluitgang|utsignal|styrsignal|"
     "regulatorutsignal|utstyrning|utgang|padrag|udgang|udgangssignal|styresignal|"
     "regulatorutgang|ohjaus|ohjausarvo|ohjaussignaali|laehtoe|ulostulo|"
     "saeaetimenlaehtoe|kimenet|beavatkozojel|szabalyozokimenet|iesire|iesireregulator|"
     "comanda|marimedecomanda|выход|выходрегулятора|управляющеевоздействие|управление|"
     "управляющийсигнал|выходнойсигнал|操作量|出力|出力値|操作出力|操作信号|調節計出力|"
     "输出|输出值|控制输出|控制量|操作值|调节输出|阀位输出|阀门输出|控制器输出|輸出|"
     "輸出值|출력|출력값|제어출력|조작량|조작값|controleffort|esforco|"
     "esforcodecontrole|acaodecontrole|esfuerzodecontrol|acciondecontrol|con|activeout|"
     "activeoutput|workingoutput|wrkop|outp"},
    {Part::kMv, "mv|manipulatedvariable|manipulatedvalue"},
    {Part::kY,
     "y|pv|meas|istwert|processvalue|processvariable|processoutput|regelgroesse|pvin|"
     "pvout|pveu|measuredvalue|measurement|messwert|controlledvariable|mesure|medida|"
     "medicion|misura|meetwaarde|wartoscmierzona|wartoscaktualna|wartoscprocesowa|"
     "wartoscrzeczywista|zmiennaprocesowa|wielkoscregulowana|pomiar|skutecnahodnota|"
     "merenahodnota|namerenahodnota|regulovanavelicina|procesnihodnota|skutocnahodnota|"
     "meranahodnota|oelcuem|olcum|oelcuelendeger|olculendeger|gercekdeger|prosesdegeri|"
     "prosesdegiskeni|variaveldeprocesso|variaveldoprocesso|valordeprocesso|"
     "valordoprocesso|valormedido|medicao|variabledeproceso|variabledelproceso|"
     "valordeproceso|valordelproceso|valorreal|valoremisurato|variabilediprocesso|"
     "variabileregolata|valorediprocesso|valoreattuale|grandeurreglee|valeurmesuree|"
     "variabledeprocede|variabledeprocessus|ist|istwertregler|prozesswert|"
     "gemetenwaarde|proceswaarde|procesvariabele|werkelijkewaarde|aervaerde|maetvaerde|"
     "processvaerde|erverdi|maleverdi|prosessverdi|malevaerdi|procesvaerdi|"
     "prosessvariabel|mittaus|mittausarvo|mitattuarvo|oloarvo|prosessiarvo|mertertek|"
     "ellenorzojel|tenylegesertek|szabalyozottjellemzo|valoaremasurata|marimemasurata|"
     "marimereglata|masura|измеренноезначение|текущеезначение|измерение|"
     "регулируемаявеличина|технологическийпараметр|測定値|現在値|計測値|制御量|"
     "プロセス値|実測値|测量值|过程值|实际值|过程变量|当前值|实时值|被控量|測量值|"
     "측정값|측정치|현재값|현재치|공정값|me|actual|actualvalue|actvalue"},
    {Part::kSp,
     "sp|sv|spt|stpt|setpt|setpoint|sollwert|wsp|fuehrungsgroesse|spout|spint|spin|"
     "setvalue|speu|consigne|consigna|gewenstewaarde|wartosczadana|zadana|"
     "zadanahodnota|pozadovanahodnota|ziadanahodnota|set|ayardegeri|setdegeri|"
     "istenendeger|referencia|pontodeajuste|valordesejado|valordereferencia|"
     "puntodeajuste|puntodeconsigna|valordeconsigna|riferimento|valoreimpostato|"
     "pointdeconsigne|soll|workingsp|workingsetpoint|wrksp|setpunt|instelwaarde|"
     "instelpunt|streefwaarde|boervaerde|settpunkt|skalverdi|saetpunkt|setpunkt|"
     "setvaerdi|asetusarvo|ohjearvo|alapjel|alapertek|eloirtertek|referinta|"
     "valoareprescrisa|consemn|задание|уставка|заданноезначение|設定値|目標値|设定值|"
     "给定值|設定值|目标值|설정값|설정치|목표값"},
    {Part::kX,
     "x|pos|position|valveposition|stem|stemposition|stellung|travel|valvetravel|"
     "stemtravel|actualtravel|stemlift|hub|ventilhub|ventilstellung|rueckmeldung|"
     "stellungsrueckmeldung|rbk|readback|polozeniezaworu|pozycjazaworu|polohaventilu|"
     "polohaventila|poloha|posicao|posicaodavalvula|posicion|posicionvalvula|"
     "posiciondelavalvula|posizione|posizionevalvola|positionvanne|recopie|"
     "ouverturevanne|klepstand|positie|ventillaege|ventilposisjon|ventilstilling|"
     "asento|venttiilinasento|szelepallas|pozitie|pozitieventil|положение|"
     "положениеклапана|弁開度|バルブ開度|開度|阀位|阀位反馈|阀门开度|开度|밸브개도|개도"},
    {Part::kTag,
     "tag|tagname|name|point|pointname|pointid|varname|variable|variablenname|item|"
     "itemid|itemname|tagpath|path|tagid|signal|series|messstelle|kennzeichen|fullname|"
     "entityid|metric|sensorid|topic|nodeid|browsename|displayname|tagindex|tagno|"
     "field|channelname|pointpath|itempath|datapoint|tags|valueid|bezeichnung|"
     "datenpunkt|nom|nombre|nome|nazwa|nazev|nimi|位号|点名|变量名|标签|タグ|タグ名|"
     "타그|태그|태그명|тег|имя|переменная|fqn|data|datasource|dataitem|dataitemname|"
     "parameter|param|attribute|property|module|modul|block|blockname"},
    {Part::kValue,
     "value|val|vvalue|wert|varvalue|trendvalue|floatvalue|numericvalue|reading|valeur|"
     "valor|valore|waarde|valueasreal|valueasdouble|realvalue|doublevalue|numvalue|"
     "state|valuenum|numericval|lastvalue|wartosc|hodnota|deger|vaerde|verdi|vaerdi|"
     "arvo|ertek|valoare|значение|値|值|数值|값"},
    {Part::kMillis,
     "ms|msec|millis|millisec|milliseconds|millisekunden|millitm|millisecs|millisecond|"
     "mseccol|millisekunde|fff|мс"},
});

using PartWord = std::pair<std::string_view, Part>;

std::vector<PartWord> sorted_words() {
  std::vector<PartWord> out;
  for (const auto& [part, words] : kPartWords) {
    for_each_word(words, [&out, part = part](std::string_view word) {
      out.emplace_back(word, part);
    });
  }
  std::ranges::sort(out);
  return out;
}

// O(log n).
Part part_word(std::string_view folded) {
  static const std::vector<PartWord> kWords = sorted_words();
  const auto found = std::ranges::lower_bound(kWords, folded, {}, &PartWord::first);
  return found != kWords.end() && found->first == folded ? found->second : Part::kNone;
}

// Beginnings of words in longer names.
constexpr std::string_view kMoved =
    "valve|pwm|heater|pump|command|control|duty|output|xmv|input|drive|dac|cmd";
constexpr std::string_view kMeasured =
    "xmeas|actual|temp|level|flow|press|speed|humidity|measured|adc|veloc|encoder|angle|"
    "rpm|weight|druck|durchfl|niveau|nivel|presi|caudal|vaza|static";

// Words of what is wanted, and of what it lacks: neither u nor y.
constexpr std::string_view kAims = "sp|set|ref|aim|dev|err|goal|soll|stpt";
constexpr std::string_view kAimBeginnings =
    "setp|target|desired|sollw|error|deviation|reference";

bool is_aim(std::string_view piece) {
  const bool numbered = piece.size() > 3 && piece.ends_with("sp") &&  // t2sp
                        wire::is_digit(piece[piece.size() - 3]);
  return numbered || is_one_of(piece, kAims) || begins_with_one_of(piece, kAimBeginnings);
}

// AI1, AO: what a card reads and what it puts out.
Part part_of_card(std::string_view piece) {
  const std::string_view letters = piece.substr(0, piece.find_first_of("0123456789"));
  return letters == "ao" ? Part::kU : letters == "ai" ? Part::kY : Part::kNone;
}

// T2
bool is_temperature(std::string_view piece) {
  return piece.size() > 1 && piece[0] == 't' &&
         std::all_of(piece.begin() + 1, piece.end(), wire::is_digit);
}

// Pieces behind the name that only say "the value of it".
constexpr std::string_view kValueWords =
    "value|val|cv|valuey|wert|avg|average|mean|mittelwert|readvalue|presentvalue|fcv|"
    "current|raw|interpolated|interpolation|trend";

constexpr std::string_view kUnits =
    "%|s|sec|ms|min|h|seconds|sek|m3/h|m³/h|m^3/h|m3/min|m3/s|nm3/h|nm³/h|sm3/h|l/h|"
    "l/min|l/s|kg/h|kg/s|kg/min|t/h|gpm|usgpm|gal/min|scfm|scfh|cfm|lb/h|lb/hr|lb/min|"
    "klb/h|bbl/d|bpd|mmscfd|°c|degc|deg c|c|grad c|°f|degf|deg f|f|k|bar|mbar|barg|bara|"
    "bar(g)|pa|hpa|kpa|mpa|psi|psig|psia|inh2o|mmh2o|inhg|kg/cm2|mmhg|m|mm|cm|in|ft|a|"
    "ma|v|mv|w|kw|mw|hz|rpm|1/min|u/min|ph|ppm|us/cm|m/s|n|kn|none|-|pct|percent|"
    "prozent|eu|no engunits|kj/kg|kg/m3|l|m3|kg|t|nl/min|unit|units|einheit|engunits";

}  // namespace

Part part_named(std::string_view key) {
  const Part part = part_word(folded(key));
  if (part != Part::kNone) return part;
  return is_quality_name(key) ? Part::kQuality : Part::kNone;
}

Part part_hinted(const std::vector<std::string>& pieces) {
  if (std::ranges::any_of(pieces, is_aim)) return Part::kSp;
  // Its speed is what the controller asks of a drive.
  if (std::ranges::find(pieces, "vfd") != pieces.end()) return Part::kU;
  for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
    if (is_temperature(*piece)) return Part::kY;
    if (const Part card = part_of_card(*piece); card != Part::kNone) return card;
    if (begins_with_one_of(*piece, kMoved)) return Part::kU;
    if (begins_with_one_of(*piece, kMeasured)) return Part::kY;
  }
  return Part::kNone;
}

bool is_value_word(std::string_view key) {
  return is_one_of(key, kValueWords);
}

bool is_unit(std::string_view text) {
  const std::string lower = lower_case(without_brackets(trimmed(text)));
  return is_one_of(lower, kUnits);
}

std::string_view unit_behind(std::string_view cell) {
  const std::size_t digit = cell.find_last_of("0123456789.");
  if (digit == std::string_view::npos) return {};
  const std::size_t blank = cell.find_last_of(" \xA0\xAF");
  // The digit of m3/h belongs to the unit.
  for (const std::size_t before : {digit, blank}) {
    if (before == std::string_view::npos || before + 1 >= cell.size()) continue;
    const std::string_view unit = without_blanks(cell.substr(before + 1));
    if (is_unit(unit) && unit[0] != '-') return unit;
  }
  return {};
}

std::string_view without_brackets(std::string_view unit) {
  unit = trimmed(unit);
  if (unit.size() >= 2 && ((unit.front() == '[' && unit.back() == ']') ||
                           (unit.front() == '(' && unit.back() == ')') ||
                           (unit.front() == '{' && unit.back() == '}'))) {
    unit = trimmed(unit.substr(1, unit.size() - 2));
  }
  return unit;
}

}  // namespace workbench
