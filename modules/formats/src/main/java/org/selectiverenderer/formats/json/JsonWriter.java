package org.selectiverenderer.formats.json;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.PrettyPrinter;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;

/** Writes indented JSON with LF line ends, for programs and people. */
public final class JsonWriter {
  private static final DefaultIndenter LINES = new DefaultIndenter("  ", "\n");

  private JsonWriter() {}

  /** Streams the content of a JSON text. */
  public interface Content {
    /** Writes one value. */
    void write(JsonGenerator json) throws IOException;
  }

  /** Writes a tree; an array of numbers or strings takes one line. */
  public static String of(JsonNode tree) {
    return text(
        json -> JsonTree.MAPPER.writeTree(json, tree),
        new DefaultPrettyPrinter().withObjectIndenter(LINES));
  }

  /** Writes streamed content, too long for a tree; each array element takes a line of its own. */
  public static String of(Content content) {
    return text(
        content, new DefaultPrettyPrinter().withObjectIndenter(LINES).withArrayIndenter(LINES));
  }

  private static String text(Content content, PrettyPrinter printer) {
    StringWriter text = new StringWriter();
    try (JsonGenerator json = new JsonFactory().createGenerator(text)) {
      json.setPrettyPrinter(printer);
      content.write(json);
    } catch (IOException e) {
      throw new UncheckedIOException(e); // a StringWriter does not fail
    }
    return text.append('\n').toString();
  }
}
