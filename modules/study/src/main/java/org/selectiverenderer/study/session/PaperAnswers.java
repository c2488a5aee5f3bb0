package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.paper.DataEntryTable;
import org.selectiverenderer.study.questionnaire.paper.DataEntryTable.Filled;

/**
 * The answers that were given on paper, by participant and screen. A participant's group is the one
 * in {@code participants.tsv}, or the one typed in if the program has assigned none.
 */
public final class PaperAnswers {
  /** The answers to one screen by question, and the location of the first one in its file. */
  record Sheet(Map<String, Answer> answers, SourceLocation place) {}

  private record Key(String participant, String step) {}

  private final Map<Key, Sheet> sheets = new LinkedHashMap<>();
  private final Map<String, String> conditions = new LinkedHashMap<>();
  private final Set<String> known = new HashSet<>();
  private final Set<String> refused = new HashSet<>();

  private PaperAnswers() {}

  /** Returns no answers. */
  public static PaperAnswers none() {
    return new PaperAnswers();
  }

  /**
   * Reads data-entry tables.
   *
   * @param problems receives every answer that cannot be used
   * @throws IOException if a file cannot be read
   */
  public static PaperAnswers read(LoadedStudy material, List<Path> files, ProblemCollector problems)
      throws IOException {
    PaperAnswers paper = new PaperAnswers();
    for (ParticipantsFile.Assigned assigned : new ParticipantsFile(material.study()).all()) {
      paper.conditions.put(assigned.participant(), assigned.group());
    }
    paper.known.addAll(paper.conditions.keySet());
    for (Path file : files) {
      Optional<DataEntryTable> table =
          DataEntryTable.read(
              file,
              (participant, step) -> material.questionnaire(step, participant),
              material.wording(),
              problems);
      if (table.isPresent()) {
        paper.add(material, table.get(), problems);
      }
    }
    return paper;
  }

  private void add(LoadedStudy material, DataEntryTable table, ProblemCollector problems) {
    Set<Key> others = Set.copyOf(sheets.keySet());
    Set<Key> told = new HashSet<>();
    for (Filled row : table.rows()) {
      Key key = new Key(row.participant(), row.step());
      if (!belongs(material, row, problems)) {
        continue;
      }
      if (others.contains(key)) {
        if (told.add(key)) {
          problems.error(
              row.location(),
              ("the answers of participant %s about %s are also in another file; "
                      + "these are left out")
                  .formatted(row.participant(), row.step()));
        }
        continue;
      }
      sheets
          .computeIfAbsent(key, first -> new Sheet(new LinkedHashMap<>(), row.location()))
          .answers()
          .put(row.question(), row.answer());
    }
  }

  /**
   * Returns whether a row belongs to a participant whose condition is known; reports each other
   * participant once.
   */
  private boolean belongs(LoadedStudy material, Filled row, ProblemCollector problems) {
    String id = row.participant();
    if (refused.contains(id)) {
      return false;
    }
    Optional<String> typed = material.study().design().group(row.condition()).map(StudyGroup::name);
    String fault = "";
    if (!id.matches(SessionFolder.LABEL)) {
      fault = "a participant's id must consist of letters and digits";
    } else if (known.contains(id)) {
      if (!row.condition().isEmpty() && !typed.equals(Optional.of(conditions.get(id)))) {
        fault =
            "the table has the condition %s, but %s was assigned"
                .formatted(row.condition(), conditions.get(id));
      }
    } else if (!padded(id).equals(id) && known.contains(padded(id))) {
      fault =
          "there is a participant %s: did a spreadsheet remove the leading zeros?"
              .formatted(padded(id));
    } else if (typed.isEmpty() && material.study().design().groups().size() > 1) {
      fault = "participants.tsv assigns no condition, and the table names none of the study";
    } else {
      String own = typed.orElse(material.study().design().groups().get(0).name());
      String earlier = conditions.putIfAbsent(id, own);
      if (earlier != null && !earlier.equals(own)) {
        fault = "the table names two conditions";
      }
    }
    if (!fault.isEmpty()) {
      refused.add(id);
      sheets.keySet().removeIf(key -> key.participant().equals(id));
      problems.error(
          row.location(),
          "participant %s: %s; the answers from paper are left out".formatted(id, fault));
    }
    return fault.isEmpty();
  }

  /** Pads an id with zeros to three digits, as the program numbers participants. */
  private static String padded(String id) {
    return "0".repeat(Math.max(0, 3 - id.length())) + id;
  }

  /** Returns the participants with answers, in the files' order. */
  Set<String> participants() {
    Set<String> all = new LinkedHashSet<>();
    sheets.keySet().forEach(key -> all.add(key.participant()));
    return all;
  }

  /** Returns the condition of one of {@link #participants}. */
  Optional<String> condition(String participant) {
    return Optional.ofNullable(conditions.get(participant));
  }

  /** Returns a participant's answers to a screen. */
  Optional<Sheet> sheet(String participant, String step) {
    return Optional.ofNullable(sheets.get(new Key(participant, step)));
  }

  /** Returns a participant's answers, by the ids of the steps. */
  Map<String, Sheet> sheets(String participant) {
    Map<String, Sheet> own = new LinkedHashMap<>();
    sheets.forEach(
        (key, sheet) -> {
          if (key.participant().equals(participant)) {
            own.put(key.step(), sheet);
          }
        });
    return own;
  }
}
