package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.statistics.report.DesignReport.Cells;
import org.selectiverenderer.statistics.script.DesignScript;
import org.selectiverenderer.statistics.script.DesignScript.Model;

/** Runs a script by R and reads its results. */
final class RScriptRun {
  /** A longer line of R is cut off in messages. */
  private static final int LONGEST = 300;

  private static final Pattern FACTOR = Pattern.compile("\\bf([1-5])\\b");

  private final String program;
  private final Duration limit;

  /**
   * @param program name or path of Rscript
   * @param limit after which R is ended
   */
  RScriptRun(String program, Duration limit) {
    this.program = program;
    this.limit = limit;
  }

  /**
   * Returns a table of results for each of the analyses; empty if R or a package is missing or R
   * fails, which is reported to {@code problems}.
   */
  Optional<List<Cells>> tables(DesignScript script, ProblemCollector problems) throws IOException {
    Path folder = Files.createTempDirectory("selective-renderer-r");
    try {
      Path file = folder.resolve("analysis.R");
      Path results = folder.resolve("results.csv");
      Path output = folder.resolve("output.txt");
      Files.writeString(file, script.script("data.csv"));
      Files.write(folder.resolve("data.csv"), script.data().getBytes(StandardCharsets.UTF_8));
      Optional<String> fault = fault(folder, List.of(file, results), output);
      if (fault.isPresent() || !Files.isRegularFile(results)) {
        problems.error(
            SourceLocation.of(program),
            fault.orElse("R has written no results") + "; the report has no results of R");
        return Optional.empty();
      }
      return CsvTable.parse("results of R", CsvTable.bytes(results), problems::error)
          .map(table -> tables(script, table));
    } finally {
      delete(folder);
    }
  }

  private Optional<String> fault(Path folder, List<Path> arguments, Path output)
      throws IOException {
    List<String> command = new ArrayList<>(List.of(program, "--no-init-file", "--no-restore"));
    arguments.forEach(argument -> command.add(argument.toString()));
    Process process;
    try {
      process =
          new ProcessBuilder(command)
              .directory(folder.toFile())
              .redirectErrorStream(true)
              .redirectOutput(output.toFile())
              .start();
    } catch (IOException e) {
      return Optional.of(
          "there is no Rscript to run; install R (r-project.org), or take the script with"
              + " --r-script to a machine that has it");
    }
    try {
      process.getOutputStream().close();
      if (!process.waitFor(limit.toMillis(), TimeUnit.MILLISECONDS)) {
        return Optional.of("R took longer than %d s".formatted(limit.toSeconds()));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.of("R was interrupted");
    } finally {
      process.descendants().forEach(ProcessHandle::destroyForcibly);
      process.destroyForcibly();
    }
    return process.exitValue() == 0
        ? Optional.empty()
        : Optional.of("R failed: " + lastLine(output));
  }

  private static String lastLine(Path output) throws IOException {
    String text = new String(Files.readAllBytes(output), StandardCharsets.UTF_8).strip();
    String last = text.substring(text.lastIndexOf('\n') + 1);
    String line =
        last.equals("Execution halted") || last.equals("Calls:")
            ? text.lines().filter(each -> each.startsWith("Error")).findFirst().orElse(last)
            : last;
    return line.substring(0, Math.min(LONGEST, line.length()));
  }

  private static List<Cells> tables(DesignScript script, CsvTable table) {
    List<Cells> tables = new ArrayList<>();
    for (int i = 0; i < script.models().size(); i++) {
      Model model = script.models().get(i);
      String number = Integer.toString(i + 1);
      List<List<String>> rows = new ArrayList<>();
      for (CsvRow row : table.rows()) {
        if (row.cell("analysis").equals(number)) {
          rows.add(
              List.of(
                  DesignScript.effect(model, row.cell("effect")),
                  named(model, row.cell("model")),
                  row.cell("statistic"),
                  rounded(row.cell("value"), 3),
                  rounded(row.cell("df1"), 2),
                  rounded(row.cell("df2"), 2),
                  probability(row.cell("p")),
                  rounded(row.cell("ges"), 3)));
        }
      }
      tables.add(
          new Cells(
              "The same by R (afex"
                  + (model.mixed() ? ", lme4" : "")
                  + "), without a correction of sphericity",
              List.of("effect", "model", "statistic", "value", "df1", "df2", "p", "ηG²"),
              rows));
    }
    return tables;
  }

  /** Returns a model with the names of its factors. */
  private static String named(Model model, String text) {
    return FACTOR
        .matcher(text)
        .replaceAll(
            found -> {
              int at = Integer.parseInt(found.group(1)) - 1;
              return Matcher.quoteReplacement(
                  at < model.factors().size() ? model.factors().get(at) : found.group());
            });
  }

  private static String probability(String number) {
    String rounded = rounded(number, 4);
    return rounded.equals("0.0000") ? "< 0.0001" : rounded;
  }

  private static String rounded(String number, int decimals) {
    try {
      double value = Double.parseDouble(number);
      return value == Math.rint(value) && decimals == 2
          ? String.format(Locale.ROOT, "%.0f", value)
          : String.format(Locale.ROOT, "%." + decimals + "f", value);
    } catch (NumberFormatException e) {
      return ""; // R has no value.
    }
  }

  private static void delete(Path folder) throws IOException {
    try (var files = Files.list(folder)) {
      for (Path file : files.toList()) {
        Files.deleteIfExists(file);
      }
    }
    Files.deleteIfExists(folder);
  }
}
