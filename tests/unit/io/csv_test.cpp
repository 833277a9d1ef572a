#include "jamscape/io/csv.hpp"

#include <bit>
#include <clocale>
#include <limits>

#include "jamscape/io/compressed.hpp"
#include "jamscape/io/number_text.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace testing;
using Numbers = std::vector<double>;
using Integers = std::vector<std::int64_t>;
using Texts = std::vector<std::string>;

Table parse(const std::string& text) { return CsvFile::parse(text, "t.csv").table(); }
std::string parse_error(const std::string& text) {
  return error_of([&] { CsvFile::parse(text, "t.csv"); });
}
template <class T>
const T& values(const Table& table, const char* name) {
  return std::get<T>(table.column(name).values);
}

TEST(NumberText, Doubles) {
  EXPECT_EQ(parse_double("1.5"), 1.5);
  EXPECT_EQ(parse_double(" +1.5e3\t"), 1500.0);
  EXPECT_EQ(parse_double("-2.5D+01"), -25.0);
  EXPECT_EQ(parse_double("1d-3"), 1e-3);
  EXPECT_EQ(parse_double(".5"), 0.5);
  EXPECT_TRUE(std::signbit(*parse_double("-0")));
  EXPECT_EQ(parse_double("inf"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_double("-Infinity"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(*parse_double("NaN")));
  EXPECT_TRUE(std::isnan(*parse_double("-nan")));
  EXPECT_EQ(parse_double("4.9e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(parse_double("1e-999"), 0.0);
  EXPECT_EQ(parse_double("0." + std::string(400, '0') + "1"), 0.0);
  for (const char* wrong : {"", "-", "+", "1e", "e5", "1.5x", "1,5", "0x10", "--1", "+-1", "1e999", "3D", "D3", "1 2"})
    EXPECT_FALSE(parse_double(wrong)) << wrong;
  EXPECT_FALSE(parse_double(std::string(400, '9')));
}

TEST(NumberText, Integers) {
  EXPECT_EQ(parse_integer("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(parse_integer("+7"), 7);
  for (const char* wrong : {"", "9223372036854775808", "1.0", "-0", "7 8"}) EXPECT_FALSE(parse_integer(wrong)) << wrong;
}

TEST(NumberText, ShortestTextOfAnyDoubleReadsBack) {
  std::mt19937_64 generator(1);
  for (int k = 0; k < 20000; ++k) {
    const auto value = std::bit_cast<double>(generator());
    if (std::isnan(value)) continue;
    ASSERT_TRUE(same_bits(*parse_double(to_text(value)), value)) << to_text(value);
  }
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(-0.0), "-0");
}

TEST(Csv, TypesOfColumns) {
  const Table t = parse("a,b,c,d,e\n1,1,x,,\"1\"\n-2,.5,,2,\"2\"\n");
  EXPECT_EQ(values<Integers>(t, "a"), (Integers{1, -2}));
  EXPECT_EQ(values<Numbers>(t, "b"), (Numbers{1, .5}));
  EXPECT_EQ(values<Texts>(t, "c"), (Texts{"x", ""}));
  EXPECT_TRUE(std::isnan(values<Numbers>(t, "d")[0]));
  EXPECT_EQ(values<Texts>(t, "e"), (Texts{"1", "2"}));
  EXPECT_EQ(parse("a,b\n").numbers("b"), Numbers{});
  EXPECT_EQ(parse("a\n9223372036854775807\n9223372036854775808\n").numbers("a"), (Numbers{0x1p63, 0x1p63}));
}

TEST(Csv, QuotesLineEndsMarkAndMetadata) {
  const std::string text =
      "\xef\xbb\xbf# system: mu=0.5: rough\r\n# no key\r\n\r\n \"a\" , b\r\n\"x, \"\"y\"\"\r\nz\" ,1\r\n\r\n\"\",2";
  const CsvFile csv = CsvFile::parse(text, "t.csv");
  EXPECT_EQ(csv.metadata(), (CsvMetadata{{"system", "mu=0.5: rough"}}));
  EXPECT_EQ(csv.columns(), (Texts{"a", "b"}));
  EXPECT_EQ(values<Texts>(csv.table(), "a"), (Texts{"x, \"y\"\r\nz", ""}));
  EXPECT_EQ(values<Integers>(csv.table(), "b"), (Integers{1, 2}));
  EXPECT_EQ(csv.place(0, 1), "t.csv:6:5");
  EXPECT_EQ(csv.place(1, 0), "t.csv:8:1");
}

TEST(Csv, ACopyOutlivesTheOriginal) {
  CsvFile copy = CsvFile::parse("a\n\"x\"\"y\"\n", "t.csv");
  copy = CsvFile(copy);
  EXPECT_EQ(copy.field(0, 0), "x\"y");
}

TEST(Csv, ErrorsSayWhere) {
  EXPECT_NE(parse_error("").find("t.csv: the file has no header row"), std::string::npos);
  EXPECT_NE(parse_error("# only: this\n\n").find("no header row"), std::string::npos);
  EXPECT_NE(parse_error("a,b\n1,2\n3\n").find("t.csv:3:1: a row has 1 field, the header names 2 columns: '3'"),
            std::string::npos);
  EXPECT_NE(parse_error("a,b\n1,2\n3").find("cut short"), std::string::npos);
  EXPECT_NE(parse_error("a,b\n1,2,3\n").find("t.csv:2:1"), std::string::npos);
  EXPECT_NE(parse_error("a,b,a\n").find("t.csv:1:5: the column 'a' stands twice"), std::string::npos);
  EXPECT_NE(parse_error("a,b\n1,\"2\n").find("t.csv:2:3: a quote is opened but never closed"), std::string::npos);
  EXPECT_NE(parse_error("a,b\n1,\"2\"3\n").find("t.csv:2:6: text follows a closing quote"), std::string::npos);
  const CsvFile csv = CsvFile::parse("a,b\n1,2\n3,x4\n,7.5\n8,1e9\n", "t.csv");
  EXPECT_NE(error_of([&] { csv.numbers(1); }).find("t.csv:3:3: 'x4' in column 'b' is no number"), std::string::npos);
  EXPECT_NE(error_of([&] { csv.integers(0); }).find("t.csv:4:1: '' in column 'a' is no integer"), std::string::npos);
  EXPECT_EQ(CsvFile::parse("a\n3.0\n1e3\n", "t.csv").integers(0), (Integers{3, 1000}));
}

TEST(Csv, KeepsEveryBit) {
  std::mt19937_64 generator(2);
  Table t;
  Numbers numbers{-0.0, std::numeric_limits<double>::infinity(), 5};
  Integers integers{std::numeric_limits<std::int64_t>::min(), 0, 1};
  Texts texts{"", "12", "1e5"};
  const Texts some{"plain", "#", "a,b", "say \"x\"", "two\nlines", " blank ", "nan", "ρ_c", "-1"};
  for (int k = 0; k < 500; ++k) {
    double value = std::bit_cast<double>(generator());
    numbers.push_back(std::isnan(value) ? 1 : value);
    integers.push_back(static_cast<std::int64_t>(generator()));
    texts.push_back(some[generator() % some.size()]);
  }
  t.add("# text", texts);
  t.add("number, real", numbers);
  t.add("integer", integers);
  const std::string text = to_csv(t, {{"unit", "d/tau_c"}});
  const CsvFile csv = CsvFile::parse(text, "t.csv");
  const Table back = csv.table();
  EXPECT_EQ(values<Texts>(back, "# text"), texts);
  EXPECT_TRUE(same_bits(values<Numbers>(back, "number, real"), numbers));
  EXPECT_EQ(values<Integers>(back, "integer"), integers);
  EXPECT_EQ(to_csv(back, csv.metadata()), text);
}

TEST(Csv, ASingleColumnKeepsEmptyText) {
  Table t;
  t.add("a", Texts{"x", "", "y"});
  EXPECT_EQ(values<Texts>(parse(to_csv(t)), "a"), (Texts{"x", "", "y"}));
}

TEST(Csv, MetadataStayOnTheirLine) {
  Table t;
  t.add("a", Integers{1});
  EXPECT_EQ(to_csv(t, {{"stage", "two\nlines"}}), "# stage: two lines\na\n1\n");
}

TEST(Csv, ColumnsOfUnequalLength) {
  Table t;
  t.add("a", Integers{1, 2});
  t.add("b", Integers{1});
  error_of([&] { to_csv(t); });
}

TEST(Csv, AnotherLocaleChangesNothing) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE"})
    if (std::setlocale(LC_ALL, name)) break;
  EXPECT_EQ(parse_double("1.5"), 1.5);
  EXPECT_EQ(to_text(1234567.5), "1234567.5");
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Compressed, GzipAndZstdByContentNotByName) {
  const Folder folder;
  std::string text = "a,b\n";
  for (int k = 0; k < 30000; ++k) text += std::to_string(k * k % 7919) + "," + std::to_string(k) + "\n";
  for (const char* name : {"t.csv", "t.csv.gz", "t.csv.zst"}) {
    write_any_text(folder / name, text);
    EXPECT_EQ(read_any_text(folder / name), text);
    std::filesystem::rename(folder / name, folder / "renamed.txt");
    EXPECT_EQ(read_any_text(folder / "renamed.txt"), text);
  }
  write_any_text(folder / "a.gz", text);
  write_any_text(folder / "b.gz", text);
  EXPECT_EQ(bytes_of(folder / "a.gz"), bytes_of(folder / "b.gz"));
  EXPECT_LT(bytes_of(folder / "a.gz").size(), text.size() / 2);
}

TEST(Compressed, SeveralInOneFileAndEmpty) {
  const Folder folder;
  for (const char* name : {"t.gz", "t.zst"}) {
    write_any_text(folder / name, "one\n");
    const std::string one = bytes_of(folder / name);
    write_any_text(folder / name, "two\n");
    put_bytes(folder / "both", one + bytes_of(folder / name));
    EXPECT_EQ(read_any_text(folder / "both"), "one\ntwo\n");
    write_any_text(folder / name, "");
    EXPECT_EQ(read_any_text(folder / name), "");
  }
  put_bytes(folder / "empty", "");
  EXPECT_EQ(read_any_text(folder / "empty"), "");
}

TEST(Compressed, CutShortOrDamaged) {
  const Folder folder;
  std::string text;
  for (int k = 0; k < 5000; ++k) text += std::to_string(k * 7919 % 10007) + "\n";
  for (const char* name : {"t.gz", "t.zst"}) {
    write_any_text(folder / name, text);
    const std::string whole = bytes_of(folder / name);
    for (std::size_t size : {std::size_t{4}, std::size_t{11}, whole.size() / 2, whole.size() - 1}) {
      put_bytes(folder / "part", whole.substr(0, size));
      EXPECT_NE(error_of([&] { read_any_text(folder / "part"); }).find("cut short"), std::string::npos) << name << size;
    }
    put_bytes(folder / "more", whole + "junk");
    error_of([&] { read_any_text(folder / "more"); });
  }
}

TEST(Csv, WholeNumbersHaveNoThousands) {
  EXPECT_NE(error_of([] { CsvFile::parse("i;x\n1,000;0,5\n", "a.csv").integers(0); }).find("a.csv:2:1"),
            std::string::npos);
  EXPECT_NE(error_of([] { CsvFile::parse("i;x\n1,0;0.5\n", "a.csv").integers(0); }).find("a.csv:2:1"),
            std::string::npos);
  EXPECT_EQ(CsvFile::parse("i;x\n1,0;0,5\n", "a.csv").integers(0), Integers{1});
}

TEST(Csv, ColumnsWithoutANameHoldNothing) {
  const auto parse = [](const char* text) { return [text] { CsvFile::parse(text, "a.csv"); }; };
  EXPECT_NE(error_of(parse("id1,id2,fn,\n1,2,1,5\n")).find("a.csv:2:7: a column without a name holds '5'"),
            std::string::npos);
  CsvFile::parse("id1,id2,fn,\n1,2,1,\n", "a.csv");
  CsvFile::parse(",i,j,force\n0,1,2,3\n", "a.csv");
}

TEST(Csv, FilesThatCannotBeRead) {
  const Folder folder;
  EXPECT_NE(error_of([&] { read_csv(folder / "none.csv"); }).find("none.csv: "), std::string::npos);
  error_of([&] { read_csv(folder / ""); });
  Table t;
  t.add("a", Integers{1});
  error_of([&] { write_csv(folder / "no/such/t.csv", t); });
  write_csv(folder / "t.csv.gz", t);
  EXPECT_EQ(values<Integers>(read_csv(folder / "t.csv.gz"), "a"), Integers{1});
  EXPECT_EQ(folder.files(), 1u);
}

}  // namespace
}  // namespace jam
