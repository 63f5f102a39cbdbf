// Text files and XML in every encoding: recognised, chosen, and written back as they were.
#include "fixture.h"

#include "projects/exchange/plcopen/plcopen_export.h"
#include "projects/storage/project_file.h"

namespace plc::exchange {
namespace {

using Encodings = ExchangeTest;

TEST_F(Encodings, SourcesOfEveryEncodingAreReadAndWrittenBackAsFound) {
    const std::string text = "PROGRAM P\n// \xC3\xA9 \xE2\x82\xAC\nEND_PROGRAM\n";
    for (const projects::Encoding encoding :
         {projects::Encoding::Utf8, projects::Encoding::Utf8Bom, projects::Encoding::Utf16Le,
          projects::Encoding::Utf16Be, projects::Encoding::Windows1252}) {
        const auto bytes = projects::encodeText(text, encoding);
        ASSERT_TRUE(bytes);
        const std::string file = write("e/src/p.st", *bytes);
        const auto project = projects::openProject({path("e")});
        ASSERT_TRUE(project);
        EXPECT_EQ(project->sources.at(0).text, text);
        const bool isUtf8 = encoding == projects::Encoding::Utf8 || encoding == projects::Encoding::Utf8Bom;
        EXPECT_EQ(project->encodings.size(), isUtf8 ? 0u : 1u);
        ASSERT_TRUE(projects::writeSourceText(file, text + "// \xC3\xBC\n"));
        EXPECT_EQ(read(file), *projects::encodeText(text + "// \xC3\xBC\n", encoding));
        ASSERT_TRUE(projects::writeSourceText(file, text, projects::Encoding::Utf8));
        EXPECT_EQ(read(file), text);
    }
    write("w.st", "// \xE9\n");
    const auto refused = projects::writeSourceText(path("w.st"), "// \xCE\xA9\n");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.english().find("does not have the character \xCE\xA9"), std::string::npos);
    EXPECT_EQ(read(path("w.st")), "// \xE9\n");
}

const std::string kCyrillic =
    "PROGRAM P\n// \u041F\u0443\u0441\u043A \u043D\u0430\u0441\u043E\u0441\u0430, "
    "\u043E\u0442\u043A\u0440\u044B\u0442\u044C \u043A\u043B\u0430\u043F\u0430\u043D\nEND_PROGRAM\n";

std::string bytesOf(const std::string& text, projects::Encoding encoding) {
    const auto bytes = projects::encodeText(text, encoding);
    EXPECT_TRUE(bytes) << projects::nameOf(encoding) << ": " << bytes.error().english();
    return bytes ? *bytes : std::string();
}

/// The first note of that kind; empty without one.
std::string noteOf(const Imported& imported, NoteKind kind) {
    for (const Note& note : imported.report.notes)
        if (note.kind == kind) return note.message.english();
    return {};
}

TEST_F(Encodings, CyrillicTextIsToldFromWesternGreekAndChineseOne) {
    using projects::Encoding;
    const auto guessOf = [](const std::string& bytes) { return projects::decodeText(bytes).encoding; };
    EXPECT_EQ(guessOf(bytesOf(kCyrillic, Encoding::Windows1251)), Encoding::Windows1251);
    EXPECT_EQ(projects::decodeText(bytesOf(kCyrillic, Encoding::Windows1251)).text, kCyrillic);
    EXPECT_EQ(guessOf(bytesOf("// gr\u00F6\u00DFer, \u00C4\u00D6\u00DC, d\u00E9j\u00E0 vu\n", Encoding::Windows1252)),
              Encoding::Windows1252);
    EXPECT_EQ(guessOf(bytesOf("// \u03B1\u03BD\u03C4\u03BB\u03AF\u03B1 \u03BD\u03B5\u03C1\u03BF\u03CD\n",
                              Encoding::Windows1253)),
              Encoding::Windows1252);
    EXPECT_EQ(guessOf("// \xC6\xF4\xB6\xAF\xCB\xAE\xB1\xC3\xA3\xAC\xB4\xF2\xBF\xAA\xB7\xA7\n"),
              Encoding::Windows1252); // GBK
    EXPECT_EQ(guessOf("// vitesse \xE0 vide, \xE0 charge, \xE0 l'arr\xEAt\n"), Encoding::Windows1252);
    EXPECT_EQ(guessOf(kCyrillic), Encoding::Utf8);
}

TEST_F(Encodings, EveryCodePageGoesOutAsItCame) {
    std::string bytes = "// ";
    for (int byte = 0x80; byte <= 0xFF; ++byte) bytes += static_cast<char>(byte);
    std::set<std::string> texts;
    for (const std::string& name : projects::codePageNames()) {
        const auto encoding = projects::encodingNamed(name);
        ASSERT_TRUE(encoding) << name;
        const projects::DecodedText text = projects::decodeText(bytes, encoding);
        EXPECT_EQ(text.encoding, *encoding);
        EXPECT_FALSE(text.isGuessed);
        EXPECT_EQ(bytesOf(text.text, *encoding), bytes) << name;
        EXPECT_TRUE(texts.insert(text.text).second) << name << " is another one";
    }
    EXPECT_EQ(projects::encodingNamed("CP1251"), projects::Encoding::Windows1251);
    EXPECT_FALSE(projects::encodingNamed("Shift-JIS"));
    EXPECT_FALSE(projects::encodingNamed(""));
}

TEST_F(Encodings, ACodePageIsGuessedWithALineOrChosen) {
    write("t/p.st", bytesOf(kCyrillic, projects::Encoding::Windows1251));
    const Imported guessed = folder("t");
    EXPECT_EQ(fileOf(guessed, "src/p.st"), kCyrillic);
    EXPECT_NE(noteOf(guessed, NoteKind::EncodingGuessed).find("was read as Windows-1251"), std::string::npos);

    const std::string polish = "PROGRAM P\n// za\u017C\u00F3\u0142\u0107 g\u0119\u015Bl\u0105\nEND_PROGRAM\n";
    write("t/p.st", bytesOf(polish, projects::Encoding::Windows1250));
    ImportOptions options;
    options.codePage = projects::Encoding::Windows1250;
    const auto chosen = importProjects(path("t"), options);
    ASSERT_TRUE(chosen) << chosen.error().english();
    EXPECT_EQ(fileOf(chosen->front(), "src/p.st"), polish);
    EXPECT_EQ(noteOf(chosen->front(), NoteKind::EncodingRead), "The file is written in Windows-1250");
    const auto alone = importProjects(path("t/p.st"), options);
    ASSERT_TRUE(alone);
    EXPECT_EQ(fileOf(alone->front(), "src/p.st"), polish);
}

TEST_F(Encodings, XmlIsReadInTheCodePageThatItDeclares) {
    std::string xml = document(pou("Main", "program", "", st("; // \u043D\u0430\u0441\u043E\u0441")));
    xml.replace(xml.find("utf-8"), 5, "koi8-r");
    ImportOptions options;
    options.codePage = projects::Encoding::Windows1250; // the file knows better
    const auto imported = importProjects(write("k.xml", bytesOf(xml, projects::Encoding::Koi8R)), options);
    ASSERT_TRUE(imported) << imported.error().english();
    const std::string text = fileOf(imported->front(), "src/Main.st");
    EXPECT_NE(text.find("\u043D\u0430\u0441\u043E\u0441"), std::string::npos) << text;
    EXPECT_EQ(noteOf(imported->front(), NoteKind::EncodingRead), "The file is written in KOI8-R");
}

TEST_F(Encodings, AProjectSaysItsCodePage) {
    const std::string polish = "PROGRAM P\n// za\u017C\u00F3\u0142\u0107\nEND_PROGRAM\n";
    const std::string bytes = bytesOf(polish, projects::Encoding::Windows1250);
    write("c/project.json", "{\"encoding\": \"windows-1250\"}");
    const std::string file = write("c/src/deep/p.st", bytes);
    const auto project = projects::openProject({path("c")});
    ASSERT_TRUE(project) << project.error().english();
    EXPECT_EQ(project->sources.at(0).text, polish);
    ASSERT_TRUE(projects::writeSourceText(file, polish + "// \u0141\n"));
    EXPECT_EQ(read(file), bytesOf(polish + "// \u0141\n", projects::Encoding::Windows1250));
    const auto refused = projects::writeSourceText(file, "// \u043D\n");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().english().find("Windows-1250 does not have the character \u043D"), std::string::npos)
        << refused.error().english();
    EXPECT_EQ(read(file), bytesOf(polish + "// \u0141\n", projects::Encoding::Windows1250));

    write("c/project.json", "{\"encoding\": \"Martian\"}");
    const auto wrong = projects::openProject({path("c")});
    ASSERT_FALSE(wrong);
    EXPECT_NE(wrong.error().english().find("The encoding Martian is not known; choose one of Windows-1252"),
              std::string::npos)
        << wrong.error().english();
}

std::string textProgram(const std::string& constant) {
    return "PROGRAM P\nVAR\n    s : STRING(20) := '" + constant +
           "';\n    n : INT;\nEND_VAR\nn := LEN(s);\nEND_PROGRAM\n";
}

TEST_F(Encodings, AnImportChoosesWhatAStringIsByItsConstants) {
    struct Row {
        const char *constant, *encoding;
    };
    for (const auto& [constant, encoding] :
         {Row{"\u041D\u0430\u0441\u043E\u0441", "Windows-1251"}, Row{"12 \u20AC", "Windows-1252"},
          Row{"za\u017C\u00F3\u0142\u0107", "Windows-1250"}, Row{"\u03A9", "Windows-1253"}, Row{"\u6CF5", "UTF-8"},
          Row{"\u041D \u03A9", "UTF-8"}}) {
        write("s/p.st", textProgram(constant));
        const Imported imported = folder("s");
        EXPECT_EQ(types::nameOf(imported.strings), encoding);
        EXPECT_EQ(errorsOf(imported), "") << constant;
        EXPECT_NE(noteOf(imported, NoteKind::StringEncoding).find(std::string("is ") + encoding), std::string::npos);
        ASSERT_TRUE(writeImported(imported, path("s-out")));
        const auto project = projects::openProject({path("s-out")});
        ASSERT_TRUE(project) << project.error().english();
        EXPECT_EQ(project->strings, imported.strings);
        std::filesystem::remove_all(path("s-out"));
    }
    write("s/p.st", textProgram("M\u00FCller") + "// \u041D\n"); // only a comment has more
    EXPECT_EQ(folder("s").strings, types::StringCode::Latin1);
    EXPECT_EQ(noteOf(folder("s"), NoteKind::StringEncoding), "");
}

TEST_F(Encodings, WhatAStringIsGoesOutAndComesBack) {
    write("u/project.json", "{\"name\": \"u\", \"stringEncoding\": \"UTF-8\"}");
    write("u/src/P.st", textProgram("\u041D\u0430\u0441\u043E\u0441"));
    const auto project = projects::openProject({path("u")});
    ASSERT_TRUE(project) << project.error().english();
    EXPECT_EQ(project->strings, types::StringCode::Utf8);
    for (const Edition edition : {Edition::Codesys0200, Edition::Plain0201}) {
        const auto out = exportPlcopen(*project, {edition, "2020-01-01T00:00:00"});
        ASSERT_TRUE(out) << out.error().english();
        const Imported again = import(out->text);
        EXPECT_EQ(again.strings, types::StringCode::Utf8); // by the constants it would be Windows-1251
        EXPECT_EQ(noteOf(again, NoteKind::VendorDataKept), "");
    }

    write("u/project.json", "{\"name\": \"u\"}");
    const auto plain = projects::openProject({path("u")});
    ASSERT_TRUE(plain);
    const driver::Checked checked = driver::check(plain->buildInput());
    ASSERT_FALSE(checked.analysis->diagnostics.empty());
    EXPECT_EQ(checked.analysis->diagnostics.front().message.english(),
              "The character \u041D is not in STRING (Latin-1); use WSTRING, or \"stringEncoding\": \"UTF-8\" in "
              "project.json");

    write("u/project.json", "{\"stringEncoding\": \"Martian\"}");
    const auto wrong = projects::openProject({path("u")});
    ASSERT_FALSE(wrong);
    EXPECT_NE(wrong.error().english().find("The encoding Martian is not known; choose one of Latin-1"),
              std::string::npos)
        << wrong.error().english();
}

} // namespace
} // namespace plc::exchange
