package org.selectiverenderer.study.site;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.dataset.RecordedStudy;
import org.selectiverenderer.study.dataset.TableColumn;
import org.selectiverenderer.study.export.AnswerTableParser;
import org.selectiverenderer.study.export.StudyExport;
import org.selectiverenderer.study.session.CollectedAnswers;
import org.selectiverenderer.study.session.PaperAnswers;
import org.selectiverenderer.study.session.RatingBandTable;

/**
 * Puts the tables of several sites together: with a last column {@code site}, and the site's name
 * before each participant's id.
 */
public final class SiteTables {
  private static final String ID = "participant";
  private static final String BIDS_ID = "participant_id";
  private static final String SITE = "site";

  private SiteTables() {}

  /**
   * Collects the answers of all sites, as {@link CollectedAnswers#of}.
   *
   * @throws IOException if a journal cannot be read
   */
  public static CollectedAnswers collect(
      StudySites sites, OptionalInt session, boolean practice, ProblemCollector problems)
      throws IOException {
    Map<StudySite, CollectedAnswers> all = new LinkedHashMap<>();
    for (StudySite site : sites.sites()) {
      all.put(site, answers(site, session, practice, problems));
    }
    AnswerTableParser parser = new AnswerTableParser(problems);
    Merging merging = new Merging(parser, all);
    DataTable ratings = merging.table("ratings", CollectedAnswers::ratings);
    return new CollectedAnswers(
        merging.table("responses", CollectedAnswers::responses).csv(),
        ratings.csv(),
        merging.table("answers", CollectedAnswers::others).csv(),
        merging.table("scores", CollectedAnswers::scores).csv(),
        merging.table("trials", CollectedAnswers::trials).csv(),
        bands(ratings),
        all.values().stream().mapToInt(CollectedAnswers::participants).sum(),
        all.values().stream().mapToInt(CollectedAnswers::answers).sum());
  }

  private static CollectedAnswers answers(
      StudySite site, OptionalInt session, boolean practice, ProblemCollector problems)
      throws IOException {
    return CollectedAnswers.of(
        site.material(), session, practice, site.taken()::contains, PaperAnswers.none(), problems);
  }

  private record Merging(AnswerTableParser parser, Map<StudySite, CollectedAnswers> answers) {
    DataTable table(String name, Function<CollectedAnswers, String> csv) {
      Map<StudySite, DataTable> tables = new LinkedHashMap<>();
      answers.forEach(
          (site, own) -> tables.put(site, parser.table(name, "an answer", csv.apply(own))));
      return merged(tables);
    }
  }

  private static String bands(DataTable ratings) {
    List<String> columns = ratings.columns().stream().map(TableColumn::name).toList();
    RatingBandTable bands = new RatingBandTable();
    for (List<@Nullable String> row : ratings.rows()) {
      String rating = row.get(columns.indexOf("rating"));
      if (rating != null) {
        bands.add(
            cell(row, columns.indexOf("area")),
            cell(row, columns.indexOf("schema")),
            cell(row, columns.indexOf("object")),
            Integer.parseInt(rating));
      }
    }
    return bands.text();
  }

  private static String cell(List<@Nullable String> row, int at) {
    String cell = row.get(at);
    return cell == null ? "" : cell;
  }

  /**
   * Returns the tables of {@code experiment export} of all sites.
   *
   * @throws IOException if a file cannot be read
   */
  public static List<DataTable> export(StudySites sites, ProblemCollector problems)
      throws IOException {
    Map<String, Map<StudySite, DataTable>> all = new LinkedHashMap<>();
    for (StudySite site : sites.sites()) {
      StudyExport.Answers answers =
          StudyExport.Answers.of(answers(site, OptionalInt.empty(), false, problems));
      RecordedStudy recorded =
          RecordedStudy.read(site.material(), site.taken()::contains, problems);
      for (DataTable table : StudyExport.tables(recorded, answers, problems)) {
        all.computeIfAbsent(table.name(), name -> new LinkedHashMap<>()).put(site, table);
      }
    }
    return all.values().stream().map(SiteTables::merged).toList();
  }

  /** Merges tables of the same kind; a column that a site lacks is empty there. */
  static DataTable merged(Map<StudySite, DataTable> tables) {
    Map<String, TableColumn> columns = new LinkedHashMap<>();
    tables
        .values()
        .forEach(
            table -> table.columns().forEach(column -> columns.putIfAbsent(column.name(), column)));
    Set<String> names = new LinkedHashSet<>(columns.keySet());
    List<TableColumn> with = new ArrayList<>(columns.values());
    with.add(
        TableColumn.text(
            names.contains(SITE) ? "session_site" : SITE,
            "the site, with whose name the participant's id begins"));
    DataTable first = tables.values().iterator().next();
    DataTable merged = new DataTable(first.name(), first.meaning(), with);
    tables.forEach(
        (site, table) -> {
          List<String> own = table.columns().stream().map(TableColumn::name).toList();
          for (List<@Nullable String> row : table.rows()) {
            List<@Nullable Object> cells = new ArrayList<>();
            for (String name : names) {
              int at = own.indexOf(name);
              cells.add(at < 0 ? null : named(site, name, row.get(at)));
            }
            cells.add(site.name());
            merged.add(cells);
          }
        });
    return merged;
  }

  private static @Nullable String named(StudySite site, String column, @Nullable String cell) {
    if (cell == null) {
      return null;
    }
    return switch (column) {
      case ID -> site.id(cell);
      case BIDS_ID -> "sub-" + site.id(cell.replaceFirst("^sub-", ""));
      default -> cell;
    };
  }
}
