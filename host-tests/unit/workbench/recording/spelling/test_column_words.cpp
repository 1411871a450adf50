#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "workbench/recording/column_name.hpp"
#include "workbench/recording/spelling/column_words.hpp"

namespace workbench {
namespace {

TEST(ColumnWords, KnowsWholeNamesOnly) {
  EXPECT_EQ(part_named("op"), Part::kU);
  EXPECT_EQ(part_named("controlleroutput"), Part::kU);
  EXPECT_EQ(part_named("outputs"), Part::kNone);
  EXPECT_EQ(part_named(""), Part::kNone);
}

TEST(ColumnWords, OfHeadingsInTheirLanguages) {
  const std::vector<std::pair<Part, std::vector<std::string>>> headings = {
      {Part::kU,
       {"Wyjście regulatora",
        "Akční zásah",
        "Çıkış",
        "Saída do controlador",
        "Salida del controlador",
        "Uscita regolatore",
        "Sortie régulateur",
        "Regelaaruitgang",
        "Styrsignal",
        "Pådrag",
        "Ohjaus",
        "Beavatkozó jel",
        "Ieșire regulator",
        "Выход регулятора",
        "操作量",
        "控制输出",
        "제어출력",
        "Esforço de controle",
        "Esfuerzo de control",
        "Control effort"}},
      {Part::kY,
       {"Wartość mierzona", "Skutečná hodnota", "Ölçüm", "Variável de processo",
        "Valor medido", "Valore misurato", "Grandeur réglée", "Meetwaarde", "Ärvärde",
        "Måleverdi", "Mittaus", "Mért érték", "Valoare măsurată", "Измеренное значение",
        "測定値", "测量值", "현재값"}},
      {Part::kSp,
       {"Wartość zadana", "Žádaná hodnota", "Ayar değeri", "Ponto de ajuste",
        "Punto de consigna", "Riferimento", "Consigne", "Gewenste waarde", "Börvärde",
        "Settpunkt", "Asetusarvo", "Alapjel", "Referință", "Уставка", "設定値", "设定值",
        "설정값"}},
      {Part::kTime,
       {"Czas", "Čas", "Zaman", "Data/Hora", "Fecha y hora", "Horodatage", "Tijdstip",
        "Tid", "Aika", "Idő", "Время", "日時", "时间", "시간"}},
      {Part::kQuality, {"Jakość", "Qualità", "Minőség", "Качество", "质量"}}};
  for (const auto& [part, names] : headings) {
    for (const std::string& name : names) {
      EXPECT_EQ(column_name(name).part, part) << name;
      EXPECT_EQ(column_name(name).tag, "") << name;
    }
  }
}

TEST(ColumnWords, StandBehindAndInFrontOfTags) {
  EXPECT_EQ(column_name("FIC101 Wartość mierzona").tag, "fic101");
  EXPECT_EQ(column_name("Valore misurato FIC101").tag, "fic101");
  EXPECT_EQ(column_name("Valore misurato FIC101").part, Part::kY);
}

}  // namespace
}  // namespace workbench
