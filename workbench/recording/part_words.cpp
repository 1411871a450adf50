#include "workbench/recording/part_words.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace workbench {
namespace {

using namespace std::string_view_literals;

// Words of one part, a language a line, blanks between; letters without case and marks.
struct PartLine {
  Part part;
  std::string_view words;
};

constexpr auto kLines = std::to_array<PartLine>({
    {Part::kTime, "t time timestamp date datetime zeit datum zeitstempel uhrzeit"sv},
    {Part::kTime, "datumzeit datumuhrzeit timestring ts utc localtime utctime"sv},
    {Part::kTime, "sampletime recordtime trendtime elapsed elapsedtime seconds"sv},
    {Part::kTime, "sekunden microseconds microsec micros usec tstamp eventtime clock"sv},
    {Part::kTime, "xvalue horodatage temps heure fecha hora tiempo ora tempo tijd"sv},
    {Part::kTime, "datumtijd"sv},
    {Part::kTime, "czas dataiczas dataczas znacznikczasu"sv},
    {Part::kTime, "cas datumacas"sv},
    {Part::kTime, "zaman tarih saat tarihsaat tarihvesaat zamandamgasi"sv},
    {Part::kTime, "data datahora dataehora"sv},
    {Part::kTime, "fechahora fechayhora marcadetiempo"sv},
    {Part::kTime, "dataora dataeora"sv},
    {Part::kTime, "dateheure dateetheure"sv},
    {Part::kTime, "tijdstip datumentijd tijdstempel"sv},
    {Part::kTime, "tid dato tidpunkt tidspunkt klokkeslett tidsstaempel datotid"sv},
    {Part::kTime, "datumtid tidsstempel"sv},
    {Part::kTime, "aika aikaleima kellonaika paeivaemaeaerae pvm paeivaeys"sv},
    {Part::kTime, "ido idopont idobelyeg"sv},
    {Part::kTime, "timp datasiora"sv},
    {Part::kTime, "время дата датаивремя датавремя меткавремени"sv},
    {Part::kTime, "時間 時刻 日時 日付 日付時刻 タイムスタンプ"sv},
    {Part::kTime, "时间 日期 日期时间 时间戳 采样时间 记录时间 日期時間"sv},
    {Part::kTime, "시간 시각 날짜 일시 일자"sv},
    {Part::kTime, "datenum timegenerated"sv},
    {Part::kU, "u op out co cv cveu output controlleroutput controloutput"sv},
    {Part::kU, "controlsignal lmn ausgang reglerausgang stellgroesse stellwert"sv},
    {Part::kU, "stellsignal outval mvout sortie sortieregulateur commande salida"sv},
    {Part::kU, "uscita uitgang regelaaruitgang"sv},
    {Part::kU, "wyjscie wyjscieregulatora sygnalsterujacy sterowanie"sv},
    {Part::kU, "wielkoscsterujaca wielkoscnastawcza"sv},
    {Part::kU, "vystup vystupregulatoru akcnizasah akcnivelicina akcnyzasah"sv},
    {Part::kU, "cikis kontrolcikisi cikisdegeri kontroloercikisi"sv},
    {Part::kU, "saida saidadocontrolador saidadecontrole saidacontrole"sv},
    {Part::kU, "variavelmanipulada sinaldecontrole"sv},
    {Part::kU, "salidadelcontrolador salidacontrolador salidadecontrol"sv},
    {Part::kU, "variablemanipulada"sv},
    {Part::kU, "uscitaregolatore uscitadelregolatore uscitacontrollore comando"sv},
    {Part::kU, "variabilemanipolata"sv},
    {Part::kU, "sortieduregulateur commandevanne grandeurreglante signaldecommande"sv},
    {Part::kU, "stellgrad reglerausgangswert"sv},
    {Part::kU, "uitsturing stuursignaal regeluitgang"sv},
    {Part::kU, "utsignal styrsignal regulatorutsignal utstyrning utgang padrag"sv},
    {Part::kU, "udgang udgangssignal styresignal regulatorutgang"sv},
    {Part::kU, "ohjaus ohjausarvo ohjaussignaali laehtoe ulostulo"sv},
    {Part::kU, "saeaetimenlaehtoe"sv},
    {Part::kU, "kimenet beavatkozojel szabalyozokimenet"sv},
    {Part::kU, "iesire iesireregulator comanda marimedecomanda"sv},
    {Part::kU, "выход выходрегулятора управляющеевоздействие управление"sv},
    {Part::kU, "управляющийсигнал выходнойсигнал"sv},
    {Part::kU, "操作量 出力 出力値 操作出力 操作信号 調節計出力"sv},
    {Part::kU,
     "输出 输出值 控制输出 控制量 操作值 调节输出 阀位输出 阀门输出 控制器输出 輸出 輸出值"sv},
    {Part::kU, "출력 출력값 제어출력 조작량 조작값"sv},
    {Part::kU, "controleffort esforco esforcodecontrole acaodecontrole"sv},
    {Part::kU, "esfuerzodecontrol acciondecontrol"sv},
    {Part::kU, "con activeout activeoutput workingoutput wrkop outp"sv},
    {Part::kMv, "mv manipulatedvariable manipulatedvalue"sv},
    {Part::kY, "y pv meas istwert processvalue processvariable processoutput"sv},
    {Part::kY, "regelgroesse pvin pvout pveu measuredvalue measurement messwert"sv},
    {Part::kY, "controlledvariable mesure medida medicion misura meetwaarde"sv},
    {Part::kY, "wartoscmierzona wartoscaktualna wartoscprocesowa"sv},
    {Part::kY, "wartoscrzeczywista zmiennaprocesowa wielkoscregulowana pomiar"sv},
    {Part::kY, "skutecnahodnota merenahodnota namerenahodnota regulovanavelicina"sv},
    {Part::kY, "procesnihodnota skutocnahodnota meranahodnota"sv},
    {Part::kY, "oelcuem olcum oelcuelendeger olculendeger gercekdeger prosesdegeri"sv},
    {Part::kY, "prosesdegiskeni"sv},
    {Part::kY, "variaveldeprocesso variaveldoprocesso valordeprocesso"sv},
    {Part::kY, "valordoprocesso valormedido medicao"sv},
    {Part::kY, "variabledeproceso variabledelproceso valordeproceso"sv},
    {Part::kY, "valordelproceso valorreal"sv},
    {Part::kY, "valoremisurato variabilediprocesso variabileregolata"sv},
    {Part::kY, "valorediprocesso valoreattuale"sv},
    {Part::kY, "grandeurreglee valeurmesuree variabledeprocede variabledeprocessus"sv},
    {Part::kY, "ist istwertregler prozesswert"sv},
    {Part::kY, "gemetenwaarde proceswaarde procesvariabele werkelijkewaarde"sv},
    {Part::kY, "aervaerde maetvaerde processvaerde erverdi maleverdi prosessverdi"sv},
    {Part::kY, "malevaerdi procesvaerdi prosessvariabel"sv},
    {Part::kY, "mittaus mittausarvo mitattuarvo oloarvo prosessiarvo"sv},
    {Part::kY, "mertertek ellenorzojel tenylegesertek szabalyozottjellemzo"sv},
    {Part::kY, "valoaremasurata marimemasurata marimereglata masura"sv},
    {Part::kY, "измеренноезначение текущеезначение измерение регулируемаявеличина"sv},
    {Part::kY, "технологическийпараметр"sv},
    {Part::kY, "測定値 現在値 計測値 制御量 プロセス値 実測値"sv},
    {Part::kY, "测量值 过程值 实际值 过程变量 当前值 实时值 被控量 測量值"sv},
    {Part::kY, "측정값 측정치 현재값 현재치 공정값"sv},
    {Part::kY, "me actual actualvalue actvalue"sv},
    {Part::kSp,
     "sp sv spt stpt setpt setpoint sollwert wsp fuehrungsgroesse spout spint spin"sv},
    {Part::kSp, "setvalue speu consigne consigna gewenstewaarde"sv},
    {Part::kSp, "wartosczadana zadana"sv},
    {Part::kSp, "zadanahodnota pozadovanahodnota ziadanahodnota"sv},
    {Part::kSp, "set ayardegeri setdegeri istenendeger"sv},
    {Part::kSp, "referencia pontodeajuste valordesejado valordereferencia"sv},
    {Part::kSp, "puntodeajuste puntodeconsigna valordeconsigna"sv},
    {Part::kSp, "riferimento valoreimpostato"sv},
    {Part::kSp, "pointdeconsigne"sv},
    {Part::kSp, "soll workingsp workingsetpoint wrksp"sv},
    {Part::kSp, "setpunt instelwaarde instelpunt streefwaarde"sv},
    {Part::kSp, "boervaerde settpunkt skalverdi saetpunkt setpunkt setvaerdi"sv},
    {Part::kSp, "asetusarvo ohjearvo"sv},
    {Part::kSp, "alapjel alapertek eloirtertek"sv},
    {Part::kSp, "referinta valoareprescrisa consemn"sv},
    {Part::kSp, "задание уставка заданноезначение"sv},
    {Part::kSp, "設定値 目標値"sv},
    {Part::kSp, "设定值 给定值 設定值 目标值"sv},
    {Part::kSp, "설정값 설정치 목표값"sv},
    {Part::kX, "x pos position valveposition stem stemposition stellung"sv},
    {Part::kX, "travel valvetravel stemtravel actualtravel stemlift hub ventilhub"sv},
    {Part::kX, "ventilstellung rueckmeldung stellungsrueckmeldung rbk readback"sv},
    {Part::kX, "polozeniezaworu pozycjazaworu"sv},
    {Part::kX, "polohaventilu polohaventila poloha"sv},
    {Part::kX, "posicao posicaodavalvula"sv},
    {Part::kX, "posicion posicionvalvula posiciondelavalvula"sv},
    {Part::kX, "posizione posizionevalvola"sv},
    {Part::kX, "positionvanne recopie ouverturevanne"sv},
    {Part::kX, "klepstand positie"sv},
    {Part::kX, "ventillaege ventilposisjon ventilstilling"sv},
    {Part::kX, "asento venttiilinasento"sv},
    {Part::kX, "szelepallas"sv},
    {Part::kX, "pozitie pozitieventil"sv},
    {Part::kX, "положение положениеклапана"sv},
    {Part::kX, "弁開度 バルブ開度 開度"sv},
    {Part::kX, "阀位 阀位反馈 阀门开度 开度"sv},
    {Part::kX, "밸브개도 개도"sv},
    {Part::kTag, "tag tagname name point pointname pointid varname variable"sv},
    {Part::kTag, "variablenname item itemid itemname tagpath path tagid signal"sv},
    {Part::kTag, "series messstelle kennzeichen"sv},
    {Part::kTag, "fullname entityid metric sensorid topic nodeid"sv},
    {Part::kTag, "browsename displayname tagindex tagno field channelname pointpath"sv},
    {Part::kTag, "itempath datapoint tags valueid"sv},
    {Part::kTag, "bezeichnung datenpunkt"sv},
    {Part::kTag,
     "nom nombre nome nazwa nazev nimi 位号 点名 变量名 标签 タグ タグ名 타그 태그 태그명 тег"sv},
    {Part::kTag, "имя переменная"sv},
    {Part::kTag,
     "fqn data datasource dataitem dataitemname parameter param attribute property module modul block blockname"sv},
    {Part::kValue, "value val vvalue wert varvalue trendvalue floatvalue numericvalue"sv},
    {Part::kValue, "reading valeur valor valore waarde"sv},
    {Part::kValue, "valueasreal valueasdouble realvalue doublevalue numvalue state"sv},
    {Part::kValue, "valuenum numericval lastvalue"sv},
    {Part::kValue, "wartosc hodnota deger vaerde verdi vaerdi arvo ertek valoare"sv},
    {Part::kValue, "значение 値 值 数值 값"sv},
    {Part::kMillis, "ms msec millis millisec milliseconds millisekunden"sv},
    {Part::kMillis, "millitm millisecs millisecond mseccol millisekunde fff"sv},
    {Part::kMillis, "мс"sv},
});

struct PartWord {
  std::string_view word;
  Part part;
};

bool by_word(const PartWord& a, const PartWord& b) {
  return a.word < b.word;
}

std::vector<PartWord> sorted_words() {
  std::vector<PartWord> out;
  for (const PartLine& line : kLines) {
    std::string_view rest = line.words;
    while (!rest.empty()) {
      const std::size_t length = std::min(rest.find(' '), rest.size());
      out.push_back({rest.substr(0, length), line.part});
      rest.remove_prefix(std::min(length + 1, rest.size()));
    }
  }
  std::ranges::sort(out, by_word);
  return out;
}

}  // namespace

Part part_word(std::string_view folded) {
  static const std::vector<PartWord> kWords = sorted_words();
  const auto found = std::lower_bound(kWords.begin(), kWords.end(),
                                      PartWord{folded, Part::kNone}, by_word);
  return found != kWords.end() && found->word == folded ? found->part : Part::kNone;
}

}  // namespace workbench
