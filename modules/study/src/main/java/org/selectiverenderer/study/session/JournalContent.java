package org.selectiverenderer.study.session;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.formats.json.JsonTree;

/**
 * The contents of a journal, parsed line by line.
 *
 * @param events the events in order
 * @param damaged numbers, from 1, of the lines that are not valid events
 * @param lines number of lines with a line end
 * @param kept number of bytes up to the end of the last event or complete line
 * @param tail number of bytes after these: a truncated last line
 * @param ended whether the kept bytes end with a line end; if not, only the line end was cut off
 */
public record JournalContent(
    List<ObjectNode> events, List<Integer> damaged, int lines, int kept, int tail, boolean ended) {

  public JournalContent {
    events = List.copyOf(events);
    damaged = List.copyOf(damaged);
  }

  /**
   * Reads a journal.
   *
   * @throws IOException if the file cannot be read
   */
  public static JournalContent read(Path journal) throws IOException {
    return of(InputFileReader.bytes(journal));
  }

  public static JournalContent of(byte[] bytes) {
    List<ObjectNode> events = new ArrayList<>();
    List<Integer> damaged = new ArrayList<>();
    int begin = 0;
    int line = 0;
    for (int at = 0; at < bytes.length; at++) {
      if (bytes[at] == '\n') {
        line++;
        int number = line;
        if (!blank(bytes, begin, at)) {
          event(bytes, begin, at).ifPresentOrElse(events::add, () -> damaged.add(number));
        }
        begin = at + 1;
      }
    }
    Optional<ObjectNode> last = event(bytes, begin, bytes.length);
    last.ifPresent(events::add);
    int kept = last.isPresent() ? bytes.length : begin;
    return new JournalContent(events, damaged, line, kept, bytes.length - kept, last.isEmpty());
  }

  /**
   * Returns whether a line of a journal is an event: an object with the event's name. A head log
   * that it names must lie in the session's folder, where the program writes them: a journal that
   * somebody sends could name files elsewhere, which would be read and converted there.
   */
  public static boolean isEvent(JsonNode json) {
    return json.isObject()
        && json.path("event").isTextual()
        && (!json.has("head_log")
            || json.get("head_log").isTextual()
                && SessionFolder.isHeadName(json.get("head_log").asText()));
  }

  private static boolean blank(byte[] bytes, int begin, int end) {
    return new String(bytes, begin, end - begin, StandardCharsets.ISO_8859_1).isBlank();
  }

  private static Optional<ObjectNode> event(byte[] bytes, int begin, int end) {
    try {
      String text =
          StandardCharsets.UTF_8
              .newDecoder()
              .decode(ByteBuffer.wrap(bytes, begin, end - begin))
              .toString();
      JsonNode json = JsonTree.parse(text);
      return isEvent(json) ? Optional.of((ObjectNode) json) : Optional.empty();
    } catch (CharacterCodingException | JsonProcessingException e) {
      return Optional.empty(); // The caller reports the line's number.
    }
  }
}
