package org.selectiverenderer.x3d.source;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.CharsetEncoder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * The decoded text of a file, and the encoding and byte order mark for writing it back. Immutable.
 */
public final class DecodedText {
  private final SourceText source;
  private final String characters;
  private final byte[] mark;
  private final boolean exact;

  private DecodedText(SourceText source, byte[] bytes) {
    this.source = source;
    this.characters = source.head(Integer.MAX_VALUE);
    this.mark = Arrays.copyOf(bytes, source.mark());
    this.exact =
        source.complaint() == null && (source.ascii() || Arrays.equals(bytes(characters), bytes));
  }

  /** Decodes a file's uncompressed bytes. */
  public static DecodedText of(byte[] bytes) {
    return new DecodedText(SourceText.of(bytes, bytes.length), bytes);
  }

  /** Returns the text without byte order mark. */
  public String characters() {
    return characters;
  }

  /** Returns the name of the encoding, such as {@code UTF-8}. */
  public String encoding() {
    return source.charset().name();
  }

  /** Returns the decoding error, if any; invalid bytes are then replaced in the characters. */
  public Optional<String> complaint() {
    return Optional.ofNullable(source.complaint());
  }

  /** Returns whether encoding reproduces the same bytes; otherwise writing the text loses data. */
  public boolean exact() {
    return exact;
  }

  /**
   * Parses the elements, as {@link ElementTree#of}, without a copy of the characters.
   *
   * @param in the source of the elements
   */
  public ElementTree elements(ElementSource in) throws XmlParseException {
    return new ElementTree(ElementParser.root(source, in, 0, 0), in);
  }

  /** Encodes another text; unencodable characters become character references. */
  public byte[] bytes(String changed) {
    byte[] encoded =
        charset().equals(StandardCharsets.UTF_8) && whole(changed)
            ? changed.getBytes(StandardCharsets.UTF_8) // ten times as fast as an encoder
            : encoded(charset().newEncoder(), changed);
    if (encoded == null) {
      CharsetEncoder encoder = charset().newEncoder(); // the first one has given up half-way
      StringBuilder escaped = new StringBuilder();
      changed
          .codePoints()
          .forEach(
              c -> {
                String character = Character.toString(c);
                escaped.append(encoder.canEncode(character) ? character : "&#" + c + ";");
              });
      encoded = escaped.toString().getBytes(charset());
    }
    if (mark.length == 0) {
      return encoded;
    }
    byte[] bytes = Arrays.copyOf(mark, mark.length + encoded.length);
    System.arraycopy(encoded, 0, bytes, mark.length, encoded.length);
    return bytes;
  }

  private Charset charset() {
    return source.charset();
  }

  /** Returns whether a text has no surrogates, which have no encoding of their own. */
  private static boolean whole(String text) {
    for (int i = 0; i < text.length(); i++) {
      if (Character.isSurrogate(text.charAt(i))) {
        return false;
      }
    }
    return true;
  }

  private static byte @Nullable [] encoded(CharsetEncoder encoder, String text) {
    try {
      ByteBuffer buffer = encoder.encode(CharBuffer.wrap(text));
      byte[] bytes = new byte[buffer.remaining()];
      buffer.get(bytes);
      return bytes;
    } catch (CharacterCodingException e) {
      return null;
    }
  }
}
