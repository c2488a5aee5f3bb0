package org.selectiverenderer.base.json;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.PrettyPrinter;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;

/** Writes JSON for programs that people may look at too: indented, each line ended by LF. */
public final class JsonText {
  private static final DefaultIndenter LINES = new DefaultIndenter("  ", "\n");

  private JsonText() {}

  /** Something that is written. */
  public interface Content {
    /** Writes one value. */
    void write(JsonGenerator json) throws IOException;
  }

  /** A tree; a list of numbers or texts is one line. */
  public static String of(JsonNode tree) {
    return text(
        json -> JsonTree.MAPPER.writeTree(json, tree),
        new DefaultPrettyPrinter().withObjectIndenter(LINES));
  }

  /** What is too long for a tree; a list has each value in a line of its own. */
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
      throw new UncheckedIOException(e); // A StringWriter does not fail.
    }
    return text.append('\n').toString();
  }
}
