package org.selectiverenderer.x3d.json;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.io.UncheckedIOException;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.json.JsonTree;
import org.selectiverenderer.x3d.source.DocumentBuilder;
import org.selectiverenderer.x3d.source.SourceText;
import org.selectiverenderer.x3d.source.XmlFault;

/** The tokens of a text with the offsets at which they start. */
final class JsonTokens implements AutoCloseable {
  private final DocumentBuilder document;
  private final JsonParser parser;
  private @Nullable JsonToken now;

  JsonTokens(DocumentBuilder document) {
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

  /** Goes to the next token. */
  JsonToken next() throws XmlFault {
    JsonToken token = advance();
    if (token == null) {
      throw document.fault(document.text().length(), "the file is cut off here");
    }
    now = token;
    return token;
  }

  private @Nullable JsonToken advance() throws XmlFault {
    try {
      return parser.nextToken();
    } catch (JsonProcessingException e) {
      throw broken(e);
    } catch (IOException e) {
      throw new UncheckedIOException("memory cannot fail to be read", e);
    }
  }

  private XmlFault broken(JsonProcessingException e) {
    long at = e.getLocation() == null ? 0 : e.getLocation().getCharOffset();
    int offset = (int) Math.max(0, Math.min(at, document.text().length()));
    boolean cut = e.getOriginalMessage().contains("end-of-input");
    return cut
        ? document.fault(document.text().length(), "the file is cut off here")
        : document.fault(offset, "this is not valid JSON: " + sentence(e));
  }

  /** Without the parser's list of all that would be right. */
  private static String sentence(JsonProcessingException e) {
    return JsonTree.sentence(e)
        .replaceFirst(": (was expecting|expected a valid value) \\(JSON.*", "");
  }

  /** Looks that nothing follows. */
  void end() throws XmlFault {
    if (advance() != null) {
      throw document.fault(start(), "there is text after the end of the scene");
    }
  }

  /** The token gone to last. */
  JsonToken now() {
    if (now == null) {
      throw new IllegalStateException("no token has been gone to");
    }
    return now;
  }

  /** The offset at which it starts. */
  int start() {
    return (int) parser.currentTokenLocation().getCharOffset();
  }

  /** Its text: a name, a string without quotes and escapes, a number as it is written. */
  String text() throws XmlFault {
    try {
      return parser.getText();
    } catch (JsonProcessingException e) {
      throw broken(e);
    } catch (IOException e) {
      throw new UncheckedIOException("memory cannot fail to be read", e);
    }
  }

  /** The same of a token that must be a plain value. */
  String scalar() throws XmlFault {
    if (!now().isScalarValue()) {
      throw document.fault(start(), "a string or a number must stand here");
    }
    return text();
  }

  /** Leaves the object or list that has begun, if it is one. */
  void skip() throws XmlFault {
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
