package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.time.DateTimeException;
import java.time.LocalDate;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.command.ProgramVersion;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.statistics.report.Provenance;
import picocli.CommandLine.Option;

/** The option for the date of a report, from which the report's provenance is made. */
final class ReportDateOption {
  @Option(
      names = "--date",
      paramLabel = "YYYY-MM-DD",
      description =
          "date of the report (default: today for text and HTML, none for JSON and CSV, so that the"
              + " same input gives the same bytes)")
  private @Nullable String date;

  Provenance provenance() throws IOException {
    try {
      return new Provenance(
          ProgramVersion.PROGRAM,
          ProgramVersion.number(),
          date == null ? LocalDate.now() : LocalDate.parse(date),
          date != null);
    } catch (DateTimeException e) {
      throw CommandException.usage("--date must be a day such as 2026-05-01, not " + date);
    }
  }
}
