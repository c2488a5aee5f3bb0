package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.statistics.data.ResponsesCsvWriter;
import org.selectiverenderer.statistics.report.ManuscriptFiles;
import org.selectiverenderer.statistics.report.Provenance;
import org.selectiverenderer.statistics.script.RScriptGenerator;
import org.selectiverenderer.statistics.study.StudyAnalysis;
import picocli.CommandLine.Option;

/** The options for the folders into which the parts of an analysis are written. */
final class StudyOutputOptions {
  private static final String ANSWERS = "usable-answers.csv";

  @Option(
      names = "--figures",
      paramLabel = "DIR",
      description = "writes each plot as an SVG file into a folder")
  private @Nullable Path figures;

  @Option(
      names = "--tables",
      paramLabel = "DIR",
      description =
          "writes tables to paste (APA style; HTML, LaTeX, CSV), sentences and the paragraph on"
              + " methods into a folder")
  private @Nullable Path tables;

  @Option(
      names = "--r",
      paramLabel = "DIR",
      description =
          "writes the usable answers and a script for R into a folder; it repeats the analyses and"
              + " adds the mixed probit of single answers")
  private @Nullable Path script;

  /** Returns whether any of the options is given. */
  boolean wanted() {
    return figures != null || tables != null || script != null;
  }

  /** Checks before the analysis that the outputs are folders. */
  void check() {
    check("--figures", figures);
    check("--tables", tables);
    check("--r", script);
  }

  private static void check(String option, @Nullable Path folder) {
    if (folder != null && Files.exists(folder) && !Files.isDirectory(folder)) {
      throw CommandException.environment(option + " " + folder + ": is a file, not a folder");
    }
  }

  /**
   * Writes all files or none.
   *
   * @param files the command's input files, which must not be overwritten
   */
  void write(StudyAnalysis study, Provenance provenance, CommandFileCheck files, Console console)
      throws IOException {
    Map<Path, String> all = new LinkedHashMap<>();
    if (figures != null) {
      add("--figures", figures, ManuscriptFiles.figures(study), files, all);
    }
    if (tables != null) {
      add("--tables", tables, ManuscriptFiles.tables(study, provenance), files, all);
    }
    if (script != null) {
      Map<String, String> parts = new LinkedHashMap<>();
      parts.put(ANSWERS, ResponsesCsvWriter.of(study.responses().usable()));
      parts.put(RScriptGenerator.NAME, RScriptGenerator.analysis(ANSWERS, study.scoring()));
      add("--r", script, parts, files, all);
    }
    files.check();
    FileTransaction writing = new FileTransaction(FileOperations.PRIVATE);
    all.forEach((file, text) -> writing.add(file, text.getBytes(StandardCharsets.UTF_8)));
    for (Path left : writing.commit()) {
      console.message(left + ": the previous file could not be deleted; you can delete it");
    }
  }

  private static void add(
      String option,
      Path folder,
      Map<String, String> parts,
      CommandFileCheck files,
      Map<Path, String> all) {
    parts.forEach(
        (name, text) -> {
          Path file = folder.resolve(name);
          files.writes(option, file);
          all.put(file, text);
        });
  }
}
