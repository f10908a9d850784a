package org.cleft;

import java.nio.charset.StandardCharsets;

/** Texts as the library has them: UTF-8, closed by a zero. */
final class Text {
    private Text() {}

    /** Of bytes without the zero; "" for null. */
    static String of(byte[] bytes) {
        return bytes == null ? "" : new String(bytes, StandardCharsets.UTF_8);
    }

    /** With the zero. {@code name} is the argument that the text is. */
    static byte[] bytes(String name, String text) {
        if (text == null)
            throw new NullPointerException(name);
        if (text.indexOf('\0') >= 0)
            throw new IllegalArgumentException(name + " has a zero character in it");
        return (text + "\0").getBytes(StandardCharsets.UTF_8);
    }
}
