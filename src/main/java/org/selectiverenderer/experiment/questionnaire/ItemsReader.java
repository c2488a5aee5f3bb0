package org.selectiverenderer.experiment.questionnaire;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.csv.CsvColumns;
import org.selectiverenderer.base.csv.CsvNumbers;
import org.selectiverenderer.base.csv.CsvRow;
import org.selectiverenderer.base.csv.CsvTable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.experiment.study.QuestionKind;
import org.selectiverenderer.experiment.study.Study;
import org.selectiverenderer.statistics.detection.Response;

/**
 * Reads the items of a questionnaire: {@code area,object,consistency,present} or {@code
 * area,schema,object}, and a column of names for each language. A fault means no items: a
 * questionnaire with a question missing cannot be compared with the others.
 */
public final class ItemsReader {
  private static final String UNUSED = "; the questionnaire is not used";

  private final QuestionKind kind;
  private final String language;
  private final Problems problems;
  private final Map<String, Integer> lines = new HashMap<>();

  private ItemsReader(QuestionKind kind, String language, Problems problems) {
    this.kind = kind;
    this.language = language;
    this.problems = problems;
  }

  /**
   * Reads them.
   *
   * @param language whose names are needed
   * @return empty when there are faults, which are then in {@code problems}
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<List<QuestionItem>> read(
      Study.Questionnaire questionnaire, String language, Problems problems) throws IOException {
    Problems own = new Problems(problems::add);
    ItemsReader reader = new ItemsReader(questionnaire.kind(), language, own);
    Optional<CsvTable> table =
        CsvTable.read(
            questionnaire.items(),
            CsvColumns.of(reader.needed()),
            (at, message) -> own.error(at, message + UNUSED));
    List<QuestionItem> items = table.map(reader::items).orElse(List.of());
    return own.any() ? Optional.empty() : Optional.of(items);
  }

  private List<String> needed() {
    List<String> needed = new ArrayList<>(columns());
    needed.add(language);
    return needed;
  }

  private List<QuestionItem> items(CsvTable table) {
    List<String> needed = needed();
    if (!table.require(needed, String.join(",", needed))) {
      return List.of();
    }
    List<QuestionItem> items = new ArrayList<>();
    for (CsvRow row : table.rows()) {
      for (String column : needed) {
        if (row.cell(column).isEmpty()) {
          problems.error(row.location(column), "the " + column + " is missing" + UNUSED);
        }
      }
      String area = row.cell("area");
      String object = row.cell("object");
      Integer earlier = lines.putIfAbsent(area + '/' + object, row.location().line());
      if (earlier != null) {
        problems.error(
            row.location("object"),
            "%s is listed a second time for %s; line %d has it already%s"
                .formatted(object, area, earlier, UNUSED));
      }
      items.add(item(row, area, object));
    }
    if (items.isEmpty()) {
      problems.error(Location.of(table.file()), "there are no items" + UNUSED);
    }
    return items;
  }

  private List<String> columns() {
    return switch (kind) {
      case RECOGNITION -> List.of("area", "object", "consistency", "present");
      case EXPECTANCY -> List.of("area", "schema", "object");
    };
  }

  private QuestionItem item(CsvRow row, String area, String object) {
    Map<String, String> names = Map.of(language, row.cell(language));
    if (kind == QuestionKind.EXPECTANCY) {
      return new QuestionItem(area, row.cell("schema"), object, "", false, names);
    }
    String type = row.cell("consistency").toLowerCase(Locale.ROOT);
    if (!Response.TYPES.contains(type)) {
      problems.error(
          row.location("consistency"),
          CsvNumbers.quoted(type)
              + " is unknown; known are "
              + String.join(", ", Response.TYPES)
              + UNUSED);
    }
    String present = row.cell("present").toLowerCase(Locale.ROOT);
    if (!present.equals("yes") && !present.equals("no")) {
      problems.error(
          row.location("present"), CsvNumbers.quoted(present) + " is not yes or no" + UNUSED);
    }
    return new QuestionItem(area, "", object, type, present.equals("yes"), names);
  }
}
