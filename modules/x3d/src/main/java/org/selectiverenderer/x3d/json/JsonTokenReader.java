package org.selectiverenderer.x3d.json;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.io.UncheckedIOException;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.source.SourceText;
import org.selectiverenderer.x3d.source.XmlParseException;

/** Reads the tokens of a JSON text with their offsets. */
final class JsonTokenReader implements AutoCloseable {
  private final ElementTreeBuilder document;
  private final JsonParser parser;
  private @Nullable JsonToken now;

  JsonTokenReader(ElementTreeBuilder document) {
    this.document = document;
    SourceText text = document.text();
    char[] characters = new char[text.length()];
    for (int i = 0; i < characters.length; i++) {
      characters[i] = text.charAt(i);
    }
    try {
      parser = new JsonFactory().createParser(characters);
    } catch (IOException e) {
      throw new UncheckedIOException("memory cannot fail to be read", e);
    }
  }

  /** Advances to the next token and returns it. */
  JsonToken next() throws XmlParseException {
    JsonToken token = advance();
    if (token == null) {
      throw document.fault(document.text().length(), "the file is cut off here");
    }
    now = token;
    return token;
  }

  private @Nullable JsonToken advance() throws XmlParseException {
    try {
      return parser.nextToken();
    } catch (JsonProcessingException e) {
      throw broken(e);
    } catch (IOException e) {
      throw new UncheckedIOException("memory cannot fail to be read", e);
    }
  }

  private XmlParseException broken(JsonProcessingException e) {
    long at = e.getLocation() == null ? 0 : e.getLocation().getCharOffset();
    int offset = (int) Math.max(0, Math.min(at, document.text().length()));
    boolean cut = e.getOriginalMessage().contains("end-of-input");
    return cut
        ? document.fault(document.text().length(), "the file is cut off here")
        : document.fault(offset, "this is not valid JSON: " + sentence(e));
  }

  /** Returns the parser's message without its list of expected tokens. */
  private static String sentence(JsonProcessingException e) {
    return JsonTree.sentence(e)
        .replaceFirst(": (was expecting|expected a valid value) \\(JSON.*", "");
  }

  /** Checks that no token follows. */
  void end() throws XmlParseException {
    if (advance() != null) {
      throw document.fault(start(), "there is text after the end of the scene");
    }
  }

  /** Returns the current token. */
  JsonToken now() {
    if (now == null) {
      throw new IllegalStateException("there is no current token");
    }
    return now;
  }

  /** Returns the offset of the current token. */
  int start() {
    return (int) parser.currentTokenLocation().getCharOffset();
  }

  /** Returns the text of the current token: a name, an unescaped string, or a number as written. */
  String text() throws XmlParseException {
    try {
      return parser.getText();
    } catch (JsonProcessingException e) {
      throw broken(e);
    } catch (IOException e) {
      throw new UncheckedIOException("memory cannot fail to be read", e);
    }
  }

  /** Returns the text of the current token, which must be a scalar value. */
  String scalar() throws XmlParseException {
    if (!now().isScalarValue()) {
      throw document.fault(start(), "a string or a number must stand here");
    }
    return text();
  }

  /** Skips the object or array that begins at the current token, if any. */
  void skip() throws XmlParseException {
    int depth = 0;
    while (true) {
      depth += now().isStructStart() ? 1 : now().isStructEnd() ? -1 : 0;
      if (depth == 0) {
        return;
      }
      next();
    }
  }

  @Override
  public void close() {
    try {
      parser.close();
    } catch (IOException e) {
      throw new UncheckedIOException("memory cannot fail to be closed", e);
    }
  }
}
