#include <orris/glsl/syntax/function_syntax.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

std::string mistake(const std::string& text) {
  const auto found = findSyntaxMistake(text);
  return found ? std::to_string(found->offset) + " " + found->message : "";
}

std::string inBody(const std::string& statement) {
  return mistake("void f() { " + statement + " }");
}

TEST(FunctionSyntax, takes_what_a_parser_without_types_takes) {
  for (const std::string text :
       {"float f(const in vec3 a[2], out Light l, float) { return a[0].x; }",
        "vec2[2] f(void) { return vec2[](vec2(1), vec2(2)); }",
        "highp float f() { precision mediump float; return 1.0e-3f; }",
        "void f() { for (int i = 0, j = 1; i < 3; ++i, j--) if (i == 2) break; else continue; }",
        "void f() { for (;;) { } while (bool b = g()) ; do { discard; } while (true); }",
        "void f() { switch (n) { case 1: case 2: g(); break; default: ; } }",
        "void f() { struct S { float a, b[2]; } s; const S t[2] = { {1, {2, 3}}, {4}, }; }",
        "void f() { Unknown x = y ? a, b : c ? d : e; x.yz *= -m[1][2].length() << 3u; }",
        "void f() { if (a) { } else if (b) g(); ; (x) = y; a[i++] = !b && ~c == 1; }",
        "void f() { } float g(float x) { return x; }", ""}) {
    EXPECT_EQ(mistake(text), "") << text;
  }
}

TEST(FunctionSyntax, names_what_was_expected_and_where) {
  EXPECT_EQ(inBody("int a = ;"), "19 syntax error: expected an expression before ';'");
  EXPECT_EQ(inBody("int a = 1"), "21 syntax error: expected ';' before '}'");
  EXPECT_EQ(inBody("g(1, );"), "16 syntax error: expected an expression before ')'");
  EXPECT_EQ(inBody("if (a { }"), "17 syntax error: expected ')' before '{'");
  EXPECT_EQ(inBody("float 1x;"), "17 syntax error: expected ';' before '1x'");
  EXPECT_EQ(inBody("a b c;"), "15 syntax error: expected ';' before 'c'");
  EXPECT_EQ(inBody("x = { 1 };"), "15 syntax error: expected an expression before '{'");
  EXPECT_EQ(inBody("else g();"), "11 syntax error: expected an expression before 'else'");
  EXPECT_EQ(mistake("void f(float a b) { }"), "15 syntax error: expected ')' before 'b'");
  EXPECT_EQ(mistake("void f() { g(); "), "16 syntax error: expected '}' before the end of it");
}

TEST(FunctionSyntax, deep_nesting_is_refused_and_not_followed) {
  const std::string deep(100000, '(');
  EXPECT_NE(inBody("x = " + deep + ";").find("fewer brackets"), std::string::npos);
  EXPECT_NE(inBody(std::string(100000, '{')).find("fewer blocks"), std::string::npos);
}

}  // namespace
}  // namespace orris
