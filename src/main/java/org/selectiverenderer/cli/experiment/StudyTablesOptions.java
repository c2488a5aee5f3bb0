package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.statistics.script.RScriptGenerator;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.dataset.RecordedStudy;
import org.selectiverenderer.study.export.StudyExport;
import org.selectiverenderer.study.session.CollectedAnswers;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PaperAnswers;
import org.selectiverenderer.study.site.SiteTables;
import org.selectiverenderer.study.site.StudySites;
import picocli.CommandLine.Mixin;

/** The options for what is in the tables of a study: answers on paper, or several sites. */
final class StudyTablesOptions {
  @Mixin private PaperTablesOption paper = new PaperTablesOption();

  @Mixin private SitesOption sites = new SitesOption();

  /**
   * Reads all tables of a study, or of its sites.
   *
   * @return empty when the sites do not go together, which is then in {@code problems}
   */
  Optional<List<DataTable>> read(LoadedStudy material, ProblemCollector problems)
      throws IOException {
    if (sites.any()) {
      if (!paper.tables().isEmpty()) {
        throw CommandException.usage(
            "--paper and --from: answers on paper are exported at their site, without --from");
      }
      Optional<StudySites> all = sites.read(material, problems);
      return all.isEmpty() ? Optional.empty() : Optional.of(SiteTables.export(all.get(), problems));
    }
    CollectedAnswers answers =
        CollectedAnswers.of(
            material,
            OptionalInt.empty(),
            PaperAnswers.read(material, paper.tables(), problems),
            problems);
    return Optional.of(
        StudyExport.tables(
            RecordedStudy.read(material, problems), StudyExport.Answers.of(answers), problems));
  }

  /** Returns the R script that analyses recognition answers, if there are any. */
  static Map<String, String> scripts(List<DataTable> tables) {
    return tables.stream()
            .anyMatch(
                table ->
                    (table.name() + ".csv").equals(StudyExport.RESPONSES)
                        && !table.rows().isEmpty())
        ? Map.of(RScriptGenerator.NAME, RScriptGenerator.analysis(StudyExport.RESPONSES))
        : Map.of();
  }
}
