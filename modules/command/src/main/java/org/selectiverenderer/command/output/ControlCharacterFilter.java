package org.selectiverenderer.command.output;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;

/**
 * A stream of UTF-8 text in which control characters other than tabs and line ends are written as
 * their escapes, such as {@code \u001b}. In JSON, which has them in strings only, these mean the
 * same. Lines end with LF on every system, which console windows of Windows understand too.
 */
final class ControlCharacterFilter extends FilterOutputStream {
  private static final int CUT_OFF = -1;

  /** The start of a character, or a CR whose LF may follow. */
  private byte[] held = {};

  ControlCharacterFilter(OutputStream target) {
    super(target);
  }

  @Override
  public void write(int b) throws IOException {
    write(new byte[] {(byte) b}, 0, 1);
  }

  @Override
  public void write(byte[] bytes, int offset, int length) throws IOException {
    byte[] all = Arrays.copyOf(held, held.length + length);
    System.arraycopy(bytes, offset, all, held.length, length);
    held = new byte[0];
    int start = 0;
    int at = 0;
    while (at < all.length) {
      int control = control(all, at);
      if (control == 0) {
        if (all[at] == '\r') {
          out.write(all, start, at - start); // LF follows
          start = at + 1;
        }
        at++;
        continue;
      }
      out.write(all, start, at - start);
      if (control == CUT_OFF) {
        held = Arrays.copyOfRange(all, at, all.length);
        return;
      }
      escape(all, at, control);
      at += control;
      start = at;
    }
    out.write(all, start, all.length - start);
  }

  private void escape(byte[] bytes, int offset, int length) throws IOException {
    int character = new String(bytes, offset, length, StandardCharsets.UTF_8).codePointAt(0);
    out.write(ControlCharacterEscaper.escape(character).getBytes(StandardCharsets.US_ASCII));
  }

  @Override
  public void flush() throws IOException {
    if (held.length == 1 && held[0] == '\r') {
      escape(held, 0, 1);
    } else {
      out.write(held);
    }
    held = new byte[0];
    out.flush();
  }

  /**
   * Returns the number of bytes of the control character that starts at an index: 0 for other
   * characters, {@link #CUT_OFF} if more bytes are needed to tell.
   */
  private static int control(byte[] bytes, int at) {
    int first = bytes[at] & 0xff;
    if (first == '\n') {
      return 0;
    }
    if (first == '\r') {
      return at + 1 == bytes.length ? CUT_OFF : bytes[at + 1] == '\n' ? 0 : 1;
    }
    if (first < 0x80) {
      return ControlCharacterEscaper.isControl(first) ? 1 : 0;
    }
    int length = first == 0xe2 ? 3 : first == 0xc2 || first == 0xd8 ? 2 : 0;
    if (length == 0) {
      return 0; // no control character begins like this
    }
    if (at + length > bytes.length) {
      return CUT_OFF;
    }
    int character = new String(bytes, at, length, StandardCharsets.UTF_8).codePointAt(0);
    return ControlCharacterEscaper.isControl(character) ? length : 0;
  }
}
