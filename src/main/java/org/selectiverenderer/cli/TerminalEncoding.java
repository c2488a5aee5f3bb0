package org.selectiverenderer.cli;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.Charset;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.nio.charset.UnsupportedCharsetException;
import java.util.Locale;
import java.util.Properties;
import org.jspecify.annotations.Nullable;

/**
 * Encodes the program's UTF-8 for Windows' console windows, which show text in a code page such as
 * 437 or 737. Files and pipes get UTF-8 as on other systems.
 */
final class TerminalEncoding {
  private TerminalEncoding() {}

  /**
   * Returns a stream that takes UTF-8.
   *
   * @param stream {@code stdout} or {@code stderr}
   * @param terminal whether input and output are known to be a terminal
   * @param target where the text goes to
   */
  static OutputStream of(
      Properties properties, String stream, boolean terminal, OutputStream target) {
    Charset charset = charset(properties, stream, terminal);
    return charset.equals(StandardCharsets.UTF_8) ? target : new Transcoder(target, charset);
  }

  /**
   * Returns the charset of a stream. Java tells that of a console window; for files and pipes Java
   * 17 tells none, and newer ones tell the system's.
   */
  static Charset charset(Properties properties, String stream, boolean terminal) {
    String name = named(properties, stream);
    // Whether the stream for messages is the terminal is not known: it is where both have one
    // charset.
    boolean shown =
        terminal
            && (stream.equals("stdout")
                || name != null && name.equals(named(properties, "stdout")));
    if (!windows(properties)
        || name == null
        || (!shown && name.equalsIgnoreCase(properties.getProperty("native.encoding")))) {
      return StandardCharsets.UTF_8;
    }
    try {
      return Charset.forName(name);
    } catch (IllegalCharsetNameException | UnsupportedCharsetException e) {
      return StandardCharsets.UTF_8;
    }
  }

  private static @Nullable String named(Properties properties, String stream) {
    return properties.getProperty(
        stream + ".encoding", properties.getProperty("sun." + stream + ".encoding"));
  }

  static boolean windows(Properties properties) {
    return properties.getProperty("os.name", "").toLowerCase(Locale.ROOT).startsWith("windows");
  }

  private static final class Transcoder extends FilterOutputStream {
    private final Charset charset;
    private final CharsetDecoder decoder =
        StandardCharsets.UTF_8
            .newDecoder()
            .onMalformedInput(CodingErrorAction.REPLACE)
            .onUnmappableCharacter(CodingErrorAction.REPLACE);

    /** The start of a character whose other bytes follow. */
    private byte[] held = {};

    Transcoder(OutputStream target, Charset charset) {
      super(target);
      this.charset = charset;
    }

    @Override
    public void write(int one) throws IOException {
      write(new byte[] {(byte) one}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
      ByteBuffer all = ByteBuffer.allocate(held.length + length);
      all.put(held).put(bytes, offset, length).flip();
      CharBuffer text = CharBuffer.allocate(all.limit());
      decoder.reset().decode(all, text, false);
      held = new byte[all.remaining()];
      all.get(held);
      out.write(text.flip().toString().getBytes(charset));
    }
  }
}
