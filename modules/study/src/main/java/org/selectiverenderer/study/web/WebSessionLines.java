package org.selectiverenderer.study.web;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.selectiverenderer.base.files.Sha256;

/**
 * The lines of files in which the records of a session are, and whether all are there. The same
 * part of a session counts once, as its answer may have been lost on the way to the page.
 */
final class WebSessionLines {
  private final String session;
  private final List<WebRecordIndex.Line> lines = new ArrayList<>();
  private final Map<Integer, WebRecordIndex.Line> parts = new TreeMap<>();
  private final Map<Integer, String> contents = new HashMap<>();
  private final List<String> missing = new ArrayList<>();
  private long bytes;
  private String first = "";
  private int slot;

  WebSessionLines(String session) {
    this.session = session;
  }

  /** Counts the bytes of a line; returns whether the session has at most so many with it. */
  boolean fits(long length, long most) {
    if (bytes + length > most) {
      return false;
    }
    bytes += length;
    return true;
  }

  /** Adds a line whose session is this one. */
  void add(WebRecordIndex.Line line, JsonNode json, RecordFaults faults) {
    if (!json.path("records").isArray()) {
      lines.add(line);
      begun(json);
      return;
    }
    int part = json.path("part").asInt();
    String content = Sha256.of(json.path("records").toString().getBytes(StandardCharsets.UTF_8));
    String other = contents.putIfAbsent(part, content);
    if (other == null) {
      parts.put(part, line);
      json.path("records").forEach(this::begun);
    } else if (!other.equals(content)) {
      faults.tell(
          line.place(),
          ("part %d of the session %s is there with other content, in line %d of %s; this one is"
                  + " left out")
              .formatted(part, session, parts.get(part).number(), parts.get(part).file()));
    }
  }

  private void begun(JsonNode json) {
    String started = json.path("started").asText();
    if (first.isEmpty() || started.compareTo(first) < 0) {
      first = started;
      slot = json.path("slot").asInt();
    }
  }

  /** Takes what the receiver tells of the parts that it has. */
  void receiver(List<String> lacking) {
    missing.addAll(lacking);
  }

  String session() {
    return session;
  }

  /** Returns when the first step began, as the page tells it. */
  String first() {
    return first;
  }

  /** Returns the place in the plan that the first record names. */
  int slot() {
    return slot;
  }

  /** Returns the lines in the order in which they were sent. */
  List<WebRecordIndex.Line> lines() {
    List<WebRecordIndex.Line> all = new ArrayList<>(parts.values());
    all.addAll(lines);
    return all;
  }

  /** Returns the numbers of the parts that are missing before the last one that is there. */
  List<String> missing() {
    List<String> all = new ArrayList<>(missing);
    int next = 0;
    for (int part : parts.keySet()) {
      for (; next < part && all.size() < 1000; next++) {
        all.add(Integer.toString(next));
      }
      next = part + 1;
    }
    return all;
  }
}
