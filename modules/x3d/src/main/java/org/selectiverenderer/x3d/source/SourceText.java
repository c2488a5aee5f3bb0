package org.selectiverenderer.x3d.source;

import com.fasterxml.aalto.stax.InputFactoryImpl;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamException;
import org.codehaus.stax2.XMLStreamReader2;
import org.codehaus.stax2.io.Stax2ByteArraySource;
import org.codehaus.stax2.io.Stax2CharArraySource;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldTokenizer;

/**
 * The characters of a scene file. An ASCII file, as most are, is parsed from its bytes; any other
 * is decoded first, so that columns always count characters.
 */
public final class SourceText implements CharSequence {
  private static final int DECLARATION_LENGTH = 200;

  /** The maximum number of attributes of a tag; nodes of X3D 4.0 have at most some 40 fields. */
  static final int ATTRIBUTES = 10_000;

  // ten thousand different names have at least three letters; then come =, two quotes and a space
  private static final int SHORTEST_ATTRIBUTE = 7;

  private final byte[] bytes;
  private final int length;
  private final char @Nullable [] decoded;
  private final @Nullable String complaint;
  private final Charset charset;
  private final int mark;

  private SourceText(
      byte[] bytes,
      int length,
      char @Nullable [] decoded,
      @Nullable String complaint,
      Charset charset,
      int mark) {
    this.bytes = bytes;
    this.length = length;
    this.decoded = decoded;
    this.complaint = complaint;
    this.charset = charset;
    this.mark = mark;
  }

  /**
   * Detects the encoding by byte order mark, null bytes and XML declaration (XML 1.0, appendix F).
   */
  static SourceText of(byte[] bytes, int length) {
    int b0 = length > 0 ? bytes[0] & 0xff : -1;
    int b1 = length > 1 ? bytes[1] & 0xff : -1;
    if (b0 == 0xfe && b1 == 0xff) {
      return decode(bytes, 2, length, StandardCharsets.UTF_16BE);
    }
    if (b0 == 0xff && b1 == 0xfe) {
      return decode(bytes, 2, length, StandardCharsets.UTF_16LE);
    }
    if (b0 == 0 && b1 == '<') {
      return decode(bytes, 0, length, StandardCharsets.UTF_16BE);
    }
    if (b0 == '<' && b1 == 0) {
      return decode(bytes, 0, length, StandardCharsets.UTF_16LE);
    }
    boolean marked = b0 == 0xef && b1 == 0xbb && length > 2 && (bytes[2] & 0xff) == 0xbf;
    int start = marked ? 3 : 0;
    String declared = marked ? "utf-8" : declaredEncoding(bytes, length);
    boolean usual =
        switch (declared) {
          case "", "utf-8", "utf8", "us-ascii", "iso-8859-1" -> true;
          default -> false;
        };
    if (usual && AsciiScanner.only(bytes, start, length)) {
      byte[] text = marked ? Arrays.copyOfRange(bytes, start, length) : bytes;
      Charset named = charset(declared);
      return new SourceText(
          text, length - start, null, null, named == null ? StandardCharsets.UTF_8 : named, start);
    }
    Charset charset = charset(declared);
    if (charset == null) {
      SourceText text = decode(bytes, start, length, StandardCharsets.UTF_8);
      return new SourceText(
          bytes,
          text.length,
          text.decoded,
          "the encoding "
              + FieldTokenizer.quote(declared)
              + " is not known; the file is read as UTF-8",
          StandardCharsets.UTF_8,
          start);
    }
    return decode(bytes, start, length, charset);
  }

  /** Returns whether it is parsed from bytes that all are ASCII. */
  boolean ascii() {
    return decoded == null;
  }

  /** Returns the source text of characters, such as those of an edited text. */
  public static SourceText of(CharSequence text) {
    CharBuffer characters = CharBuffer.wrap(text);
    return of(new byte[0], characters, null, StandardCharsets.UTF_8, 0);
  }

  private static String declaredEncoding(byte[] bytes, int length) {
    String head =
        new String(bytes, 0, Math.min(length, DECLARATION_LENGTH), StandardCharsets.ISO_8859_1);
    int end = head.indexOf("?>");
    int at = head.startsWith("<?xml") && end > 0 ? head.substring(0, end).indexOf("encoding") : -1;
    if (at < 0) {
      return "";
    }
    String rest = head.substring(at + "encoding".length(), end).strip();
    if (!rest.startsWith("=")) {
      return "";
    }
    rest = rest.substring(1).strip();
    int close = rest.isEmpty() ? -1 : rest.indexOf(rest.charAt(0), 1);
    return close < 0 ? "" : rest.substring(1, close).toLowerCase(Locale.ROOT);
  }

  private static @Nullable Charset charset(String name) {
    if (name.isEmpty() || name.startsWith("utf-16")) {
      // a declaration that can be read byte by byte is not UTF-16, whatever it declares
      return StandardCharsets.UTF_8;
    }
    return name.chars().allMatch(c -> c > ' ' && c < 127)
            && name.matches("[a-z0-9][a-z0-9._:+-]*")
            && Charset.isSupported(name)
        ? Charset.forName(name)
        : null;
  }

  private static SourceText decode(byte[] bytes, int start, int end, Charset charset) {
    ByteBuffer in = ByteBuffer.wrap(bytes, start, end - start);
    try {
      CharBuffer text =
          charset
              .newDecoder()
              .onMalformedInput(CodingErrorAction.REPORT)
              .onUnmappableCharacter(CodingErrorAction.REPORT)
              .decode(in);
      return of(bytes, text, null, charset, start);
    } catch (CharacterCodingException e) {
      // a file of an old editor, which in nearly all cases is Latin-1
      boolean wide = charset.name().startsWith("UTF-16") || charset.name().startsWith("UTF-32");
      Charset instead = wide ? charset : StandardCharsets.ISO_8859_1;
      in.position(start);
      return of(
          bytes,
          instead.decode(in),
          wide
              ? "the file has bytes that are not valid " + charset + "; they are shown as \ufffd"
              : "the file has bytes that are not valid " + charset + "; it is read as ISO-8859-1",
          instead,
          start);
    }
  }

  private static SourceText of(
      byte[] bytes, CharBuffer text, @Nullable String complaint, Charset charset, int mark) {
    char[] decoded = new char[text.remaining()];
    text.get(decoded);
    return new SourceText(bytes, decoded.length, decoded, complaint, charset, mark);
  }

  /**
   * Returns the offset of the first tag that may have too many attributes, or -1. The parser
   * compares all attributes of a tag pairwise, so that a million would take days. Since {@code <}
   * ends every tag, well-formed or not, it is enough to count the signs = in between.
   */
  int floodedTag() {
    if (length < ATTRIBUTES * SHORTEST_ATTRIBUTE) {
      return -1;
    }
    int tag = 0;
    int count = 0;
    for (int at = mark(0); at < length - 1; at = mark(at + 1)) {
      if (charAt(at) == '<') {
        tag = at;
        count = 0;
      } else {
        char next = charAt(at + 1);
        if ((next == '"' || next == '\'' || next <= ' ') && ++count > ATTRIBUTES) {
          return tag;
        }
      }
    }
    return -1;
  }

  /** Returns the offset of the next {@code <} or {@code =}; the length if there is none. */
  private int mark(int from) {
    char[] letters = decoded;
    if (letters == null) {
      return AsciiScanner.mark(bytes, from, length);
    }
    int at = from;
    while (at < length && (letters[at] & ~1) != '<') {
      at++;
    }
    return at;
  }

  /** Returns the text with its entities expanded, of the same file. */
  SourceText expandedTo(CharSequence expanded) {
    char[] letters = new char[expanded.length()];
    for (int i = 0; i < letters.length; i++) {
      letters[i] = expanded.charAt(i);
    }
    return new SourceText(new byte[0], letters.length, letters, complaint, charset, mark);
  }

  /** Returns the text up to an offset. */
  SourceText cutAt(int offset) {
    return new SourceText(bytes, offset, decoded, complaint, charset, mark);
  }

  /** Returns the character encoding of the file. */
  Charset charset() {
    return charset;
  }

  /** Returns the length of the byte order mark. */
  int mark() {
    return mark;
  }

  /** Returns the error in the character encoding, or null. */
  @Nullable
  public String complaint() {
    return complaint;
  }

  @Override
  public int length() {
    return length;
  }

  /** Returns a character by its offset, not counting a byte order mark. */
  @Override
  public char charAt(int offset) {
    return decoded != null ? decoded[offset] : (char) bytes[offset];
  }

  /** Returns the offset of the first LF or CR in a range, or its end if there is none. */
  int lineEnd(int from, int to) {
    byte[] ascii = bytes;
    char[] letters = decoded;
    int at = from;
    if (letters != null) {
      while (at < to && letters[at] != '\n' && letters[at] != '\r') {
        at++;
      }
    } else {
      while (at < to && (ascii[at] > '\r' || ascii[at] != '\n' && ascii[at] != '\r')) {
        at++;
      }
    }
    return at;
  }

  @Override
  public CharSequence subSequence(int start, int end) {
    // text that is not decoded is ASCII
    return decoded != null
        ? new String(decoded, start, end - start)
        : new String(bytes, start, end - start, StandardCharsets.US_ASCII);
  }

  @Override
  public String toString() {
    return head(length);
  }

  /** Returns the first characters, for detecting the encoding. */
  public String head(int most) {
    return subSequence(0, Math.min(length, most)).toString();
  }

  /** Returns an XML parser of the text, which fetches nothing and itself expands no entities. */
  XMLStreamReader2 parser() throws XMLStreamException {
    InputFactoryImpl factory = new InputFactoryImpl();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    factory.setProperty(XMLInputFactory.IS_REPLACING_ENTITY_REFERENCES, false);
    return (XMLStreamReader2)
        factory.createXMLStreamReader(
            decoded != null
                ? new Stax2CharArraySource(decoded, 0, length)
                : new Stax2ByteArraySource(bytes, 0, length));
  }
}
