package org.selectiverenderer.x3d.source;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.CharsetEncoder;
import java.util.Arrays;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * A file's characters, and how such characters become bytes again: encoding and byte order mark
 * stay as they were. Immutable.
 */
public final class EncodedText {
  private final SourceText source;
  private final String characters;
  private final byte[] mark;
  private final boolean exact;

  private EncodedText(SourceText source, byte[] bytes) {
    this.source = source;
    this.characters = source.head(Integer.MAX_VALUE);
    this.mark = Arrays.copyOf(bytes, source.mark());
    this.exact = source.complaint() == null && Arrays.equals(bytes(characters), bytes);
  }

  /** Reads a file's bytes, not compressed, whatever they are. */
  public static EncodedText of(byte[] bytes) {
    return new EncodedText(SourceText.of(bytes, bytes.length), bytes);
  }

  /** The text, without a byte order mark. */
  public String characters() {
    return characters;
  }

  /** The name of the encoding, such as {@code UTF-8}. */
  public String encoding() {
    return source.charset().name();
  }

  /** What is wrong with the encoding; the characters are then the best that can be made of it. */
  public Optional<String> complaint() {
    return Optional.ofNullable(source.complaint());
  }

  /** Whether the characters become the very bytes again. Where not, changing the text does harm. */
  public boolean exact() {
    return exact;
  }

  /**
   * The elements, as {@link ElementTree#of} has them, without a copy of the characters.
   *
   * @param in what they are to stand in
   */
  public ElementTree elements(ElementSource in) throws XmlFault {
    return new ElementTree(ElementParser.root(source, in, 0, 0), in);
  }

  /** Another text in this one's encoding; characters that it does not have become references. */
  public byte[] bytes(String changed) {
    byte[] encoded = encoded(charset().newEncoder(), changed);
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
