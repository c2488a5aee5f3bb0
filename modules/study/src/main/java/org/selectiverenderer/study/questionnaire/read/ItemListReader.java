package org.selectiverenderer.study.questionnaire.read;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.formats.csv.CsvColumnSpec;
import org.selectiverenderer.formats.csv.CsvNumberParser;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.statistics.detection.Response;
import org.selectiverenderer.study.questionnaire.ItemQuestionnaireKind;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.StimulusItem;

/**
 * Reads the items of a recognition list ({@code area,object,consistency,present}) or an expectancy
 * questionnaire ({@code area,schema,object}), with a column of names for each language. Each area
 * becomes a questionnaire of one page. A faulty table is not used at all: answers to a
 * questionnaire that lacks a question cannot be compared with the others.
 */
public final class ItemListReader {
  private static final String UNUSED = "; the questionnaire is not used";

  private final ItemQuestionnaireKind kind;
  private final String language;
  private final ProblemCollector problems;
  private final Optional<Set<String>> known;
  private final Map<String, Integer> lines = new HashMap<>();

  private ItemListReader(
      ItemQuestionnaireKind kind,
      String language,
      Optional<Set<String>> known,
      ProblemCollector problems) {
    this.known = known;
    this.kind = kind;
    this.language = language;
    this.problems = problems;
  }

  /** Reads a table of items of any areas. */
  public static Optional<List<Questionnaire>> read(
      ItemQuestionnaireKind kind,
      Path file,
      String name,
      ParticipantMessages wording,
      ProblemCollector problems)
      throws IOException {
    return read(kind, file, name, Optional.empty(), wording, problems);
  }

  /**
   * Reads a table of items.
   *
   * @param known the areas that the table may name; empty for any
   * @param name of the questionnaire in the study
   * @param wording messages in the language in which the names are needed
   * @return a questionnaire for each area, in the table's order; empty if there are faults, which
   *     are then in {@code problems}
   * @throws IOException if the file cannot be read
   */
  public static Optional<List<Questionnaire>> read(
      ItemQuestionnaireKind kind,
      Path file,
      String name,
      Optional<Set<String>> known,
      ParticipantMessages wording,
      ProblemCollector problems)
      throws IOException {
    ProblemCollector own = new ProblemCollector(problems::add);
    ItemListReader reader = new ItemListReader(kind, wording.language(), known, own);
    Optional<CsvTable> table =
        CsvTable.read(
            file,
            CsvColumnSpec.of(reader.needed()),
            (at, message) -> own.error(at, message + UNUSED));
    Map<String, List<Question>> areas = table.map(reader::areas).orElse(Map.of());
    return own.anyError()
        ? Optional.empty()
        : Optional.of(
            areas.entrySet().stream()
                .map(area -> reader.questionnaire(name, area.getKey(), area.getValue(), wording))
                .toList());
  }

  private Questionnaire questionnaire(
      String name, String area, List<Question> questions, ParticipantMessages wording) {
    String called = wording.area(area);
    QuestionnairePage page =
        new QuestionnairePage(
            area,
            wording.filled(kind.spelling() + ".title", called),
            wording.filled(kind.spelling() + ".text", called),
            Optional.empty(),
            questions,
            true,
            Optional.empty());
    return new Questionnaire(name + "-" + area, name, area, List.of(page), List.of());
  }

  private List<String> needed() {
    List<String> needed = new ArrayList<>(kind.columns());
    needed.add(language);
    return needed;
  }

  private Map<String, List<Question>> areas(CsvTable table) {
    List<String> needed = needed();
    if (!table.require(needed, String.join(",", needed))) {
      return Map.of();
    }
    Map<String, List<Question>> areas = new LinkedHashMap<>();
    for (CsvRow row : table.rows()) {
      for (String column : needed) {
        if (row.cell(column).isEmpty()) {
          problems.error(row.location(column), "the " + column + " is missing" + UNUSED);
        }
      }
      String area = row.cell("area");
      String object = row.cell("object");
      if (!areas.containsKey(area)) {
        requireKnown(row, area);
      }
      Integer earlier = lines.putIfAbsent(area + '/' + object, row.location().line());
      if (earlier != null) {
        problems.error(
            row.location("object"),
            "%s is listed a second time for %s; line %d has it already%s"
                .formatted(object, area, earlier, UNUSED));
      }
      areas
          .computeIfAbsent(area, first -> new ArrayList<>())
          .add(kind.question(item(row, area, object), row.cell(language)));
    }
    if (areas.isEmpty()) {
      problems.error(SourceLocation.of(table.file()), "there are no items" + UNUSED);
    }
    return areas;
  }

  /**
   * Reports an area that nobody knows. One that resembles a known one is mistyped and would become
   * another memory list; another one may be an area of a scene that the study does not name.
   */
  private void requireKnown(CsvRow row, String area) {
    if (area.isEmpty() || known.isEmpty() || known.get().contains(area)) {
      return;
    }
    String unknown =
        "%s is no area of the study or its scene, and not in the study's \"item_areas\""
            .formatted(CsvNumberParser.quoted(area));
    Optional<String> near = SpellingSuggester.nearest(area, known.get());
    if (near.isPresent()) {
      problems.error(
          row.location("area"),
          "%s; did you mean \"%s\"?%s".formatted(unknown, near.get(), UNUSED));
    } else {
      problems.info(
          row.location("area"), unknown + "; it has a list of its own: declare it if it is meant");
    }
  }

  private StimulusItem item(CsvRow row, String area, String object) {
    if (kind == ItemQuestionnaireKind.EXPECTANCY) {
      return new StimulusItem(area, row.cell("schema"), object, "", false);
    }
    String type = row.cell("consistency").toLowerCase(Locale.ROOT);
    if (!Response.TYPES.contains(type)) {
      problems.error(
          row.location("consistency"),
          CsvNumberParser.quoted(type)
              + " is unknown; known are "
              + String.join(", ", Response.TYPES)
              + UNUSED);
    }
    String present = row.cell("present").toLowerCase(Locale.ROOT);
    if (!present.equals("yes") && !present.equals("no")) {
      problems.error(
          row.location("present"), CsvNumberParser.quoted(present) + " is not yes or no" + UNUSED);
    }
    return new StimulusItem(area, "", object, type, present.equals("yes"));
  }
}
