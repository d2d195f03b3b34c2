// Letters as strokes on a grid of 8 units from the top of a digit to the baseline. For C and C++.
// SPDX-License-Identifier: MIT
#ifndef SAMPLES_IMAGE_GLYPHS_H
#define SAMPLES_IMAGE_GLYPHS_H

// Strokes are separated by commas, points by spaces; a point is x and y as hexadecimal digits, y down, baseline at 8.
// A stroke that begins with ~ is a smooth curve through its points; a stroke of one point is a dot.
static inline const char* glyph(char c) {
    switch (c) {
    case '0':
        return "~30 11 04 17 38 57 64 51 30";
    case '1':
        return "12 30 38";
    case '2':
        return "~02 10 30 51 53 35 08,08 58";
    case '3':
        return "~01 20 40 52 43 24,~24 44 56 47 28 07";
    case '4':
        return "48 40 06 66";
    case '5':
        return "50 10 04,~04 23 43 55 47 28 07";
    case '6':
        return "~50 21 05 17 38 56 44 24 05";
    case '7':
        return "00 50 28";
    case '8':
        return "~34 12 30 52 34 06 38 66 34";
    case '9':
        return "~18 47 53 41 20 02 14 34 53";
    case 'a':
        return "~54 33 14 05 06 17 38 57,53 58";
    case 'b':
        return "00 08,~04 23 44 55 56 47 28 07";
    case 'c':
        return "~54 33 14 05 06 17 38 57";
    case 'd':
        return "50 58,~54 33 14 05 06 17 38 57";
    case 'e':
        return "~06 56 44 33 14 05 06 17 38 57";
    case 'f':
        return "~40 21 23 28,03 43";
    case 'g':
        return "53 58,~58 4a 2a 09,~54 33 14 05 06 17 38 57";
    case 'h':
        return "00 08,~05 23 43 55 58";
    case 'i':
        return "03 08,01";
    case 'j':
        return "23 29 0a,21";
    case 'k':
        return "00 08,06 43,25 48";
    case 'l':
        return "00 08";
    case 'm':
        return "03 08,~05 13 23 34 38,~35 43 53 64 68";
    case 'n':
        return "03 08,~05 23 43 55 58";
    case 'o':
        return "~33 14 05 06 17 38 57 66 65 54 33";
    case 'p':
        return "03 0a,~04 23 44 55 56 47 28 07";
    case 'q':
        return "53 5a,~54 33 14 05 06 17 38 57";
    case 'r':
        return "03 08,~05 23 33";
    case 's':
        return "~43 23 04 25 46 37 18 07";
    case 't':
        return "~10 17 28 38,03 33";
    case 'u':
        return "53 58,~03 06 18 38 56";
    case 'v':
        return "03 38 63";
    case 'w':
        return "03 28 44 68 83";
    case 'x':
        return "03 58,53 08";
    case 'y':
        return "03 38,63 1a";
    case 'z':
        return "03 53 08 58";
    case '.':
        return "08";
    case ',':
        return "18 0a";
    case ':':
        return "04,08";
    case '=':
        return "04 54,06 56";
    case '+':
        return "05 45,23 27";
    case '-':
        return "05 45";
    case '/':
        return "50 09";
    case '%':
        return "60 08,~10 01 12 21 10,~56 47 58 67 56";
    case '(':
        return "~20 03 05 28";
    case ')':
        return "~00 23 25 08";
    default:
        return "";
    }
}

#endif
