package org.cleft;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Texts as the library has them: UTF-8, closed by a zero. */
final class Text {
    private Text() {}

    /** Of bytes without the zero; "" for null. */
    static String of(byte[] bytes) {
        return bytes == null ? "" : new String(bytes, StandardCharsets.UTF_8);
    }

    /** With the zero, of text in which %C3 stands for a byte. */
    static byte[] unescaped(String text) {
        byte[] bytes = new byte[text.length() + 1];
        int size = 0;
        for (int at = 0; at < text.length(); ++at) {
            boolean isEscape = text.charAt(at) == '%';
            bytes[size++] = (byte) (isEscape ? Integer.parseInt(text, at + 1, at + 3, 16) : text.charAt(at));
            at += isEscape ? 2 : 0;
        }
        return Arrays.copyOf(bytes, size + 1);
    }

    /** With the zero. {@code name} is the argument that the text is. */
    static byte[] bytes(String name, String text) {
        if (text == null)
            throw new NullPointerException(name);
        if (text.indexOf('\0') >= 0)
            throw new IllegalArgumentException(name + " has a zero character in it");
        if (!StandardCharsets.UTF_8.newEncoder().canEncode(text))
            throw new IllegalArgumentException(name + " has half a surrogate pair in it");
        return (text + "\0").getBytes(StandardCharsets.UTF_8);
    }
}
