package org.selectiverenderer.study.bids;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.study.dataset.RecordedSession;
import org.selectiverenderer.study.dataset.RecordedStudy;

/**
 * A study written as a BIDS dataset.
 *
 * @param sessions number of sessions in the dataset
 * @param files number of files that were written
 */
public record BidsDataset(int sessions, int files) {
  /** The version of BIDS that the files follow. */
  static final String VERSION = "1.11.0";

  /**
   * The provenance of a dataset, as {@code dataset_description.json} states it.
   *
   * @param program name of the program
   * @param version of the program
   * @param authors of the study; may be empty
   */
  public record Origin(String program, String version, List<String> authors) {
    public Origin {
      authors = List.copyOf(authors);
    }
  }

  /**
   * Writes all files, or none.
   *
   * @param folder the dataset's folder; created if it does not exist, else it must be empty
   * @param problems receives a warning for each damaged file, which is left out
   * @throws IOException if the folder is not empty, or a file cannot be read or written
   */
  public static BidsDataset write(
      RecordedStudy study, Origin origin, Path folder, ProblemCollector problems)
      throws IOException {
    requireEmpty(folder);
    BidsFileSet files = new BidsFileSet();
    files.add("dataset_description.json", description(study, origin));
    files.add("README", readme(study, origin));
    BidsParticipantFiles.participants(study, files);
    Map<String, List<RecordedSession>> people = new LinkedHashMap<>();
    for (RecordedSession session : study.sessions()) {
      people.computeIfAbsent(session.folder().participant(), id -> new ArrayList<>()).add(session);
    }
    for (Map.Entry<String, List<RecordedSession>> person : people.entrySet()) {
      BidsParticipantFiles.sessions(
          person.getKey(), person.getValue(), study.study().fade(), files);
      for (RecordedSession session : person.getValue()) {
        new BidsSessionFiles(study.material(), session, origin, files, problems).add();
      }
    }
    if (study.sessions().isEmpty()) {
      problems.warning(
          SourceLocation.of(study.study().folder().toString()),
          "the study has no sessions yet; the dataset has no data");
    }
    files.write(folder);
    return new BidsDataset(study.sessions().size(), files.size());
  }

  /** Refuses a folder with files in it: they would be taken for a part of the dataset. */
  private static void requireEmpty(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) {
      return;
    }
    try (Stream<Path> there = Files.list(folder)) {
      if (there.findAny().isPresent()) {
        throw new IOException(
            folder + ": is not empty; a dataset needs a folder of its own, name a new one");
      }
    }
  }

  private static String description(RecordedStudy study, Origin origin) {
    ObjectNode root = JsonTree.object();
    root.put("Name", study.study().name());
    root.put("BIDSVersion", VERSION);
    root.put("DatasetType", "raw");
    if (!origin.authors().isEmpty()) {
      ArrayNode authors = root.putArray("Authors");
      origin.authors().forEach(authors::add);
    }
    root.putArray("GeneratedBy")
        .addObject()
        .put("Name", origin.program())
        .put("Version", origin.version())
        .put("Description", "experiment bids");
    return JsonWriter.of(root);
  }

  private static String readme(RecordedStudy study, Origin origin) {
    return """
        %s

        An experiment with X3D scenes that were shown on a screen or in a head-mounted display,
        followed by questionnaires. Written by %s %s from the study's folder, which has more than
        this dataset: settings and checksums of each session, the head logs with what was in the
        middle of the view, and all events.

        Tasks: each step of a session is one, named by its id without hyphens. "practice" and
        "exposure..." have motion data (tracksys-head: the middle between the eyes as it was drawn,
        one sample a frame) and events; the others are questionnaires (beh).

        Time: "onset" and the channel "latency" count from the first frame. While the experimenter
        pauses there are no samples. "t" in events is the time of the scene, which stands still
        then, and "wall" the clock on the wall.

        Coordinates: metres in the world of the scene, X right, Y up, Z towards the viewer of a
        plan seen from above with -Z up; rotations are quaternions that take a viewer who looks
        along -Z, with +Y up, into this world.
        """
        .formatted(study.study().name(), origin.program(), origin.version());
  }
}
