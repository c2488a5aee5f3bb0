package org.selectiverenderer.x3d;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.CharsetEncoder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import org.codehaus.stax2.XMLStreamReader2;
import org.jspecify.annotations.Nullable;

/**
 * A scene's file as its author's text: what an edit leaves alone keeps every byte, encoding, byte
 * order mark and ends of lines included.
 */
public final class SceneText {
  private final SourceText source;
  private final String characters;
  private final byte[] mark;
  private final Charset charset;
  private final SceneElement root;

  private SceneText(SourceText source, byte[] mark, SceneElement root) {
    this.source = source;
    this.characters = source.head(Integer.MAX_VALUE);
    this.mark = mark;
    this.charset = source.charset();
    this.root = root;
  }

  /**
   * Reads a file's bytes, not compressed.
   *
   * @param name for messages
   * @throws IOException if the text could not be written again as it was, or is not well formed
   */
  public static SceneText of(String name, byte[] bytes) throws IOException {
    SourceText source = SourceText.of(bytes, bytes.length);
    if (source.complaint() != null) {
      throw new IOException(name + ": " + source.complaint() + ", so it cannot be changed safely");
    }
    SceneText text =
        new SceneText(source, Arrays.copyOf(bytes, source.mark()), elements(name, source));
    if (!Arrays.equals(text.bytes(text.characters), bytes)) {
      throw new IOException(
          name
              + ": its "
              + text.charset
              + " cannot be written again as it is, so it is not changed");
    }
    return text;
  }

  private static SceneElement elements(String name, SourceText source) throws IOException {
    if (source.floodedTag() >= 0) {
      throw new IOException(name + ": an element has more attributes than any node");
    }
    SceneElement root = null;
    SceneElement open = null;
    try {
      XMLStreamReader2 xml = source.parser();
      while (xml.hasNext()) {
        int event = xml.next();
        if (event == XMLStreamConstants.START_ELEMENT) {
          javax.xml.stream.Location at = xml.getLocationInfo().getStartLocation();
          open =
              new SceneElement(
                  xml.getLocalName(),
                  open,
                  new Location(name, at.getLineNumber(), at.getColumnNumber()),
                  at.getCharacterOffset(),
                  attributes(xml));
          if (xml.isEmptyElement()) {
            open.endAt(tagEnd(source, open.start()));
          }
          root = root == null ? open : root;
        } else if (event == XMLStreamConstants.END_ELEMENT && open != null) {
          if (open.end() == 0) {
            open.endAt(
                tagEnd(source, xml.getLocationInfo().getStartLocation().getCharacterOffset()));
          }
          open = open.parent().orElse(null);
        }
      }
    } catch (XMLStreamException e) {
      javax.xml.stream.Location at = e.getLocation();
      throw new IOException(
          new Location(
                  name, at == null ? 0 : at.getLineNumber(), at == null ? 0 : at.getColumnNumber())
              + ": "
              + XmlFaults.describe(e),
          e);
    }
    if (root == null) {
      throw new IOException(name + ": there is no element in it");
    }
    return root;
  }

  private static List<String[]> attributes(XMLStreamReader2 xml) {
    List<String[]> attributes = new ArrayList<>();
    for (int i = 0; i < xml.getAttributeCount(); i++) {
      // Coordinates may be megabytes, and nobody asks for them here.
      switch (xml.getAttributeLocalName(i)) {
        case "DEF", "USE", "containerField", "fromNode", "toNode", "localDEF", "inlineDEF", "url" ->
            attributes.add(new String[] {xml.getAttributeLocalName(i), xml.getAttributeValue(i)});
        default -> {}
      }
    }
    return attributes;
  }

  /** The offset behind the tag that begins at an offset. */
  private static int tagEnd(SourceText source, int start) {
    char quote = 0;
    for (int i = start; i < source.length(); i++) {
      char c = source.charAt(i);
      if (quote != 0) {
        quote = c == quote ? 0 : quote;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>') {
        return i + 1;
      }
    }
    return source.length();
  }

  /** The text, without a byte order mark. */
  public String characters() {
    return characters;
  }

  /** The element X3D. */
  public SceneElement root() {
    return root;
  }

  /** The place of a character. */
  public Location location(String file, int offset) {
    return source.location(file, offset);
  }

  /** Another text in this one's encoding; characters that it does not have become references. */
  public byte[] bytes(String changed) {
    CharsetEncoder encoder = charset.newEncoder();
    byte[] encoded = encoded(encoder, changed);
    if (encoded == null) {
      StringBuilder escaped = new StringBuilder();
      changed
          .codePoints()
          .forEach(
              c -> {
                String character = Character.toString(c);
                escaped.append(encoder.canEncode(character) ? character : "&#" + c + ";");
              });
      encoded = escaped.toString().getBytes(charset);
    }
    byte[] bytes = Arrays.copyOf(mark, mark.length + encoded.length);
    System.arraycopy(encoded, 0, bytes, mark.length, encoded.length);
    return bytes;
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
