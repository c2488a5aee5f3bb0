package org.selectiverenderer.study.export;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.csv.CsvErrorHandler;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.dataset.TableColumn;

/** Parses the program's CSV tables of answers and adds the documentation of their columns. */
public final class AnswerTableParser {
  private static final Map<String, TableColumn> KNOWN = known();

  private final ProblemCollector problems;

  /** Creates a parser that reports what it leaves out. */
  public AnswerTableParser(ProblemCollector problems) {
    this.problems = problems;
  }

  private static Map<String, TableColumn> known() {
    Map<String, TableColumn> known = new LinkedHashMap<>();
    for (TableColumn column :
        List.of(
            TableColumn.text("participant", "the participant's id"),
            TableColumn.whole("session", "number of the participant's session, from 1"),
            TableColumn.text("condition", "how objects were rendered"),
            TableColumn.text("area", "the area of the scene that the question is about"),
            TableColumn.text("schema", "the schema of the area"),
            TableColumn.text("object", "the object that the question is about"),
            TableColumn.text("consistency", "of the object with the schema"),
            TableColumn.yesNo(
                "present", "it was there", "it was not", "whether the object was in the scene"),
            TableColumn.yesNo(
                "response", "it was there", "it was not", "what the participant answered"),
            TableColumn.whole("confidence", "how sure, 1 (not at all) to 5 (certain)"),
            TableColumn.whole(
                "rating", "how likely the object is in the area, 1 (not at all) to 6 (very)"),
            TableColumn.number(
                "response_ms", "ms", "from when the question was shown until the answer"),
            TableColumn.whole("place", "the question's number on its screen, from 1"),
            TableColumn.text("questionnaire", "the questionnaire's name"),
            TableColumn.text("page", "the id of the questionnaire's page"),
            TableColumn.text("question", "the question's id"),
            TableColumn.text("kind", "the kind of the question"),
            TableColumn.text("value", "what was answered; several choices are joined by |"),
            TableColumn.text("group", "the participant's group"),
            TableColumn.text("block", "the block of trials"),
            TableColumn.whole("trial", "number of the trial in its block, from 1"),
            TableColumn.whole("round", "how often the block was shown, this time counted, from 1"),
            TableColumn.number(
                "ms", "ms", "from when the response was possible until it was given"),
            TableColumn.yesNo(
                "correct",
                "the response was the correct one",
                "it was not",
                "whether it was right"),
            TableColumn.text("score", "the name of the score that is computed of the answers"))) {
      known.put(column.name(), column);
    }
    return known;
  }

  private static TableColumn column(String name, String table) {
    if (name.equals("response") && table.equals("trials")) {
      return TableColumn.text("response", "the key that was pressed, or what ended the exposure");
    }
    if (name.equals("value") && table.equals("scores")) {
      return TableColumn.number("value", "", "the score");
    }
    TableColumn known = KNOWN.get(name);
    return known != null
        ? known
        : TableColumn.text(name, "column " + name + " of the program's table of " + table);
  }

  /**
   * Parses a table.
   *
   * @param csv text of the table, with a header
   */
  public DataTable table(String name, String meaning, String csv) {
    CsvTable read = CsvTable.parse(name, csv, faults()).orElseThrow();
    DataTable table =
        new DataTable(
            name, meaning, read.header().stream().map(column -> column(column, name)).toList());
    read.rows().forEach(row -> table.add(read.header().stream().map(row::cell).toList()));
    return table;
  }

  private CsvErrorHandler faults() {
    return new CsvErrorHandler() {
      @Override
      public void fault(SourceLocation at, String message) {
        problems.error(at, message + "; the table is left out");
      }

      @Override
      public void misfit(SourceLocation at, String message) {
        problems.error(at, message + "; the row is left out");
      }
    };
  }
}
