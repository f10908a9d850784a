// Tables of strokes. All are ours.
#include "io/render/letter_strokes.hpp"

#include "base/utf8.hpp"

#include <algorithm>
#include <string_view>

namespace cleft::io
{

namespace
{

// From blank to tilde.
constexpr const char* kAsciiStrokes[] = {
    "",
    "4i 4q/4e 4f",
    "2q 2m/6q 6m",
    "2e 3q/5e 6q/0i 8i/0m 8m",
    "8n 6p 2p 0n 0m 2k 6k 8i 8h 6f 2f 0h/4d 4r",
    "0q 2q 2o 0o 0q/6g 8g 8e 6e 6g/0e 8q",
    "8e 1n 1p 2q 4q 5p 5n 0i 0g 2e 5e 8i",
    "4q 4m",
    "5r 3o 3g 5d",
    "3r 5o 5g 3d",
    "4o 4g/1m 7i/7m 1i",
    "4g 4m/1j 7j",
    "4f 3c",
    "1j 7j",
    "4e 4f",
    "1d 7r",
    "2e 0g 0o 2q 6q 8o 8g 6e 2e",
    "1n 4q 4e/1e 7e",
    "0o 2q 6q 8o 8m 0e 8e",
    "0o 2q 6q 8o 8m 6k 8i 8g 6e 2e 0g/3k 6k",
    "6e 6q 0h 8h",
    "8q 1q 0k 2l 6l 8j 8g 6e 2e 0g",
    "7q 3q 0n 0g 2e 6e 8g 8j 6l 2l 0j",
    "0q 8q 3e",
    "2k 0m 0o 2q 6q 8o 8m 6k 2k 0i 0g 2e 6e 8g 8i 6k",
    "1e 5e 8h 8o 6q 2q 0o 0l 2j 6j 8l",
    "4g 4h/4l 4m",
    "4g 3d/4l 4m",
    "7n 1j 7f",
    "1l 7l/1h 7h",
    "1n 7j 1f",
    "0o 2q 6q 8o 8m 4j 4h/4e 4f",
    "6h 6m 3m 2l 2i 3h 6h 8i 8o 6q 2q 0o 0g 2e 7e",
    "0e 4q 8e/1i 7i",
    "0e 0q 6q 8o 8m 6k 0k/6k 8i 8g 6e 0e",
    "8o 6q 2q 0o 0g 2e 6e 8g",
    "0e 0q 5q 8n 8h 5e 0e",
    "8q 0q 0e 8e/0k 6k",
    "8q 0q 0e/0k 6k",
    "8o 6q 2q 0o 0g 2e 6e 8g 8k 5k",
    "0e 0q/8e 8q/0k 8k",
    "2q 6q/4q 4e/2e 6e",
    "7q 7g 5e 2e 0g",
    "0e 0q/8q 0j/2l 8e",
    "0q 0e 8e",
    "0e 0q 4k 8q 8e",
    "0e 0q 8e 8q",
    "2e 0g 0o 2q 6q 8o 8g 6e 2e",
    "0e 0q 6q 8o 8l 6j 0j",
    "2e 0g 0o 2q 6q 8o 8g 6e 2e/5h 8e",
    "0e 0q 6q 8o 8l 6j 0j/4j 8e",
    "8o 6q 2q 0o 0m 2k 6k 8i 8g 6e 2e 0g",
    "0q 8q/4q 4e",
    "0q 0g 2e 6e 8g 8q",
    "0q 4e 8q",
    "0q 2e 4n 6e 8q",
    "0e 8q/0q 8e",
    "0q 4k 8q/4k 4e",
    "0q 8q 0e 8e",
    "6r 3r 3d 6d",
    "1r 7d",
    "2r 5r 5d 2d",
    "1n 4q 7n",
    "0d 8d",
    "3q 5o",
    "1m 5m 7k 7e/7i 2i 0h 0f 1e 5e 7g",
    "0q 0e/0k 2m 5m 7k 7g 5e 2e 0g",
    "7l 5m 2m 0k 0g 2e 5e 7f",
    "7q 7e/7k 5m 2m 0k 0g 2e 5e 7g",
    "0i 7i 7k 5m 2m 0k 0g 2e 6e 7f",
    "6q 4q 3p 3e/1m 5m",
    "7m 7d 5b 2b 0c/7k 5m 2m 0k 0g 2e 5e 7g",
    "0q 0e/0k 2m 5m 7k 7e",
    "4m 4e/4p 4q",
    "4m 4d 3b 1b/4p 4q",
    "0q 0e/6m 0h/2j 7e",
    "4q 4e",
    "0e 0m/0k 2m 3m 4k 4e/4k 6m 7m 8k 8e",
    "0m 0e/0k 2m 5m 7k 7e",
    "2e 0g 0k 2m 5m 7k 7g 5e 2e",
    "0m 0b/0k 2m 5m 7k 7g 5e 2e 0g",
    "7m 7b/7k 5m 2m 0k 0g 2e 5e 7g",
    "0m 0e/0k 2m 5m",
    "7l 5m 1m 0l 0k 1j 6i 7h 7g 6e 1e 0f",
    "3p 3g 4e 6e/1m 6m",
    "0m 0g 2e 5e 7g/7m 7e",
    "0m 3e 6m",
    "0m 2e 4k 6e 8m",
    "0m 7e/7m 0e",
    "0m 3f/7m 3c 1b",
    "0m 7m 0e 7e",
    "6r 4q 4l 2j 4i 4e 6d",
    "4r 4d",
    "2r 4q 4l 6j 4i 4e 2d",
    "0i 2k 5i 7k",
};

struct OwnLetter {
    const char* letter;
    const char* strokes;
};
constexpr OwnLetter kOwnLetters[] = {
    {"ß", "0e 0o 2q 4q 6o 6m 4k 7i 7g 5e 3e"},
    {"æ", "0l 2m 4l 4g 2e 0g 0h 2i 8i 8k 6m 4l/4g 6e 8f"},
    {"Æ", "0e 4q 8q/4q 4e 8e/2i 4i/4k 7k"},
    {"œ", "4k 2m 0k 0g 2e 4g 4k 6m 8k 8i 4i/4g 6e 8f"},
    {"Œ", "8q 2q 0o 0g 2e 8e/4q 4e/4k 7k"},
    {"ð", "1o 6q/2q 7k 7g 5e 2e 0g 0j 2l 5l 7j"},
    {"Ð", "0e 0q 5q 8n 8h 5e 0e/0k 4k"},
    {"þ", "0q 0b/0k 2m 5m 7k 7g 5e 2e 0g"},
    {"Þ", "0e 0q/0o 6o 8m 8j 6h 0h"},
    {"đ", "7q 7e/7k 5m 2m 0k 0g 2e 5e 7g/4o 9o"},
    {"Đ", "0e 0q 5q 8n 8h 5e 0e/0k 4k"},
    {"ł", "4q 4e/2j 6l"},
    {"Ł", "1q 1e 8e/0j 5l"},
    {"ø", "2e 0g 0k 2m 5m 7k 7g 5e 2e/0d 7n"},
    {"Ø", "2e 0g 0o 2q 6q 8o 8g 6e 2e/0d 8r"},
    {"ı", "4m 4e"},
    {"°", "2n 2q 5q 5n 2n"},
    {"¿", "8g 6e 2e 0g 0i 4l 4n/4p 4q"},
    {"¡", "4c 4j/4l 4m"},
    {"²", "2p 3q 5q 6p 2l 6l"},
    {"³", "2q 6q 4o 6n 6m 5l 2l"},
    {"·", "4j 4k"},
    {"×", "1h 7n/7h 1n"},
    {"–", "1j 7j"},
    {"’", "4q 3n"},
    {"µ", "0m 0b/0g 2e 5e 7g/7m 7e"},
    {"α", "8m 6g 4e 2e 0g 0k 2m 4m 6k 8e"},
    {"β", "0b 0o 2q 4q 6o 6m 4k 7i 7g 5e 2e 0g"},
    {"γ", "0m 2m 4f 4b/8m 4f"},
    {"δ", "6q 3q 2o 6k 7i 7g 5e 2e 0g 0i 2k 6k"},
    {"ε", "7l 5m 2m 0l 0k 2j 5j/2j 0h 0g 2e 5e 7f"},
    {"ζ", "1q 6q 1k 0h 2e 5e 6d 5b 3b"},
    {"η", "0m 0e/0k 2m 5m 7k 7b"},
    {"θ", "2e 0g 0o 2q 5q 7o 7g 5e 2e/0k 7k"},
    {"ι", "4m 4g 5e"},
    {"κ", "0m 0e/6m 0i/2j 7e"},
    {"λ", "0q 2q 7e/4k 0e"},
    {"μ", "0m 0b/0g 2e 5e 7g/7m 7e"},
    {"ν", "0m 3e 6m"},
    {"ξ", "7q 2q 0o 2m 5m/2m 0k 0h 2e 5e 6d 5b 3b"},
    {"ο", "2e 0g 0k 2m 5m 7k 7g 5e 2e"},
    {"π", "0m 8m/2m 2e/6m 6e"},
    {"ρ", "0b 0k 2m 5m 7k 7g 5e 2e 0g"},
    {"ς", "6l 4m 2m 0k 0h 2e 5e 6d 5b 3b"},
    {"σ", "8m 2m 0k 0g 2e 5e 7g 7k 5m"},
    {"τ", "0m 7m/4m 4g 5e"},
    {"υ", "0m 0g 2e 5e 7g 7m"},
    {"φ", "2e 0g 0k 2m 6m 8k 8g 6e 2e/4q 4b"},
    {"χ", "0m 7b/7m 0b"},
    {"ψ", "0m 0i 2g 6g 8i 8m/4q 4b"},
    {"ω", "1m 0k 0g 2e 4g 6e 8g 8k 7m/4g 4j"},
    {"Γ", "0e 0q 7q"},
    {"Δ", "0e 4q 8e 0e"},
    {"Θ", "2e 0g 0o 2q 6q 8o 8g 6e 2e/2k 6k"},
    {"Λ", "0e 4q 8e"},
    {"Ξ", "0q 8q/2k 6k/0e 8e"},
    {"Π", "0e 0q 8q 8e"},
    {"Σ", "8q 0q 4k 0e 8e"},
    {"Φ", "2h 0j 0l 2n 6n 8l 8j 6h 2h/4q 4e"},
    {"Ψ", "0q 0m 2j 6j 8m 8q/4q 4e"},
    {"Ω", "0e 3e 0i 0o 2q 6q 8o 8i 5e 8e"},
};

// Each mark by a character that looks like it, and as a character of Unicode that follows its letter.
struct MarkStrokes {
    char name;
    uint32_t combining;
    const char* strokes;  // above small letters, or below all
};
constexpr MarkStrokes kLetterMarks[] = {
    {'`', 0x300, "2q 5o"},          {'\'', 0x301, "3o 6q"},      {'^', 0x302, "2o 4q 6o"}, {'~', 0x303, "1o 3p 5o 7p"},
    {'-', 0x304, "1p 7p"},          {'u', 0x306, "2q 3o 5o 6q"}, {'.', 0x307, "4o 4p"},    {':', 0x308, "2o 2p/6o 6p"},
    {'o', 0x30A, "3o 3q 5q 5o 3o"}, {'"', 0x30B, "2o 3q/5o 6q"}, {'v', 0x30C, "2q 4o 6q"}, {',', 0x327, "4e 4d 5c 3b"},
    {';', 0x328, "5e 4c 6b"},
};

// A letter, the one that it is made of, and its mark.
constexpr std::string_view kMarkedLetters =
    "ÀA`ÁA'ÂA^ÃA~ÄA:ÅAoÇC,ÈE`ÉE'ÊE^ËE:ÌI`ÍI'ÎI^ÏI:ÑN~ÒO`ÓO'ÔO^ÕO~ÖO:ÙU`ÚU'ÛU^ÜU:ÝY'àa`áa'âa^ãa~äa:åaoçc,èe`ée'êe^ëe:"
    "ìi`íi'îi^ïi:ñn~òo`óo'ôo^õo~öo:ùu`úu'ûu^üu:ýy'ÿy:ĀA-āa-ĂAuăauĄA;ąa;ĆC'ćc'ĈC^ĉc^ĊC.ċc.ČCvčcvĎDvďdvĒE-ēe-ĔEuĕeuĖE.ėe."
    "ĘE;ęe;ĚEvěevĜG^ĝg^ĞGuğguĠG.ġg.ĢG,ĤH^ĥh^ĨI~ĩi~ĪI-īi-ĬIuĭiuĮI;įi;İI.ĴJ^ĵj^ĶK,ķk,ĹL'ĺl'ĻL,ļl,ĽLvľlvŃN'ńn'ŅN,ņn,ŇNvňnv"
    "ŌO-ōo-ŎOuŏouŐO\"őo\"ŔR'ŕr'ŖR,ŗr,ŘRvřrvŚS'śs'ŜS^ŝs^ŞS,şs,ŠSvšsvŢT,ţt,ŤTvťtvŨU~ũu~ŪU-ūu-ŬUuŭuuŮUoůuoŰU\"űu\"ŲU;ųu;"
    "ŴW^ŵw^ŶY^ŷy^ŸY:ŹZ'źz'ŻZ.żz.ŽZvžzvȘS,șs,ȚT,țt,άα'έε'ήη'ίι'όο'ύυ'ώω'";

std::string marked(std::string letter, const MarkStrokes& mark)
{
    constexpr char kSmall = 'm', kBelow = 'e';
    constexpr int kRaise = 4;  // from small letters to capitals
    std::string strokes = mark.strokes;
    if (strokes[1] > kBelow) {
        // The dots of i and j give way.
        if (const size_t dot = letter.find("/4p 4q"); dot != std::string::npos)
            letter.resize(dot);
        if (std::any_of(letter.begin(), letter.end(), [](char c) { return c > kSmall && c <= 'z'; }))
            for (size_t i = 1; i < strokes.size(); i += 3)
                strokes[i] = static_cast<char>(strokes[i] + kRaise);
    }
    return letter.empty() ? strokes : letter + "/" + strokes;
}

uint32_t take_character(std::string_view& text)
{
    const Character next = first_character(text);
    text.remove_prefix(next.bytes);
    return next.code;
}

}  // namespace

std::optional<std::string> strokes_of(uint32_t code)
{
    if (code >= ' ' && code <= '~')
        return kAsciiStrokes[code - ' '];
    for (const OwnLetter& own : kOwnLetters)
        if (first_character(own.letter).code == code)
            return own.strokes;
    for (std::string_view rest = kMarkedLetters; !rest.empty();) {
        const uint32_t letter = take_character(rest), base = take_character(rest), mark = take_character(rest);
        if (letter == code)
            return marked(*strokes_of(base),
                          *std::find_if(std::begin(kLetterMarks), std::end(kLetterMarks),
                                        [&](const MarkStrokes& row) { return uint32_t(row.name) == mark; }));
    }
    return std::nullopt;
}

std::optional<std::string> with_mark(const std::string& letter, uint32_t code)
{
    for (const MarkStrokes& mark : kLetterMarks)
        if (mark.combining == code)
            return marked(letter, mark);
    return std::nullopt;
}

}  // namespace cleft::io
