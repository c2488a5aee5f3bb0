package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.head.SceneExposureReplay;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.ProgramVersion;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.study.session.CollectedAnswers;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PaperAnswers;
import org.selectiverenderer.study.site.SiteTables;
import org.selectiverenderer.study.site.StudySites;
import org.selectiverenderer.study.web.WebSessionImport;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "collect",
    description = {
      "Collects the answers of a study into tables, from one session of each "
          + "participant: recognition answers for experiment analyse, ratings for enrich "
          + "--ratings, answers to all other questions, scores. Reports what it leaves out.",
      "Without an option it prints the recognition answers."
    },
    footer = {
      "  ./selective-renderer experiment collect mystudy --responses r.csv \\",
      "      --answers answers.csv",
      "  ./selective-renderer experiment collect mystudy --paper 003.csv,004.csv \\",
      "      --responses r.csv",
      "  ./selective-renderer experiment collect mystudy --trials trials.csv",
      "  ./selective-renderer experiment collect mystudy --web mystudy-data \\",
      "      --answers answers.csv",
      "  ./selective-renderer experiment collect mystudy --from athens=data/athens \\",
      "      --from patras=data/patras --trials trials.csv",
      "  ./selective-renderer experiment collect mystudy/pilot --ratings ratings.csv \\",
      "      --bands bands.csv"
    })
final class ExperimentCollectCommand extends CliCommand {
  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  @Option(
      names = "--responses",
      paramLabel = "F.csv",
      description = "writes the recognition answers to a file")
  private @Nullable Path responses;

  @Option(
      names = "--ratings",
      paramLabel = "F.csv",
      description = "writes the ratings to a file, one per row")
  private @Nullable Path ratings;

  @Option(
      names = "--answers",
      paramLabel = "F.csv",
      description =
          "writes the answers to all other questions, and to the form, to a file, one per row")
  private @Nullable Path others;

  @Option(
      names = "--scores",
      paramLabel = "F.csv",
      description = "writes the scores of scales to a file, such as the total of ssq")
  private @Nullable Path scores;

  @Option(
      names = "--trials",
      paramLabel = "F.csv",
      description =
          "writes the finished trials of blocks to a file, one per row, with factors, stimuli,"
              + " responses and answers")
  private @Nullable Path trials;

  @Option(
      names = "--practice",
      description = "writes the trials of practice blocks to that file, too")
  private boolean practice;

  @Option(
      names = "--bands",
      paramLabel = "F.csv",
      description =
          "writes the means of the ratings with their bands and consistency to a file "
              + "(thesis 5.1)")
  private @Nullable Path bands;

  @Option(
      names = "--session",
      paramLabel = "N",
      description =
          "number of the session to take from each participant (default: the first "
              + "whose questions are all answered, else the first with answers)")
  private @Nullable Integer number;

  @Mixin private PaperTablesOption paper = new PaperTablesOption();

  @Mixin private SitesOption sites = new SitesOption();

  @Option(
      names = "--web",
      paramLabel = "PATH",
      description =
          "first adds the sessions that browsers sent: a folder of the receiver, a file that a"
              + " participant saved, or result data of JATOS; can be repeated. Their participants"
              + " are web001, web002 and so on")
  private List<Path> web = List.of();

  ExperimentCollectCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    if (number != null && number < 1) {
      throw CommandException.usage("--session must be a whole number of at least 1");
    }
    if (sites.any() && !paper.tables().isEmpty()) {
      throw CommandException.usage(
          "--paper and --from: answers on paper are collected at their site, without --from");
    }
    if (sites.any() && !web.isEmpty()) {
      throw CommandException.usage(
          "--web and --from: sessions of browsers are added at their site, without --from");
    }
    OutputFile.check("--responses", responses, ".csv");
    OutputFile.check("--ratings", ratings, ".csv");
    OutputFile.check("--answers", others, ".csv");
    OutputFile.check("--scores", scores, ".csv");
    OutputFile.check("--trials", trials, ".csv");
    OutputFile.check("--bands", bands, ".csv");
    CommandFileCheck files =
        new CommandFileCheck()
            .writes("--responses", responses)
            .writes("--ratings", ratings)
            .writes("--answers", others)
            .writes("--scores", scores)
            .writes("--trials", trials)
            .writes("--bands", bands);
    paper.tables().forEach(table -> files.reads("--paper", table));
    files.check();
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<LoadedStudy> material =
        web.isEmpty()
            ? study.read(trust, console(), problems)
            : study.readToCopy(trust, console(), problems).map(languages -> languages.get(0));
    if (material.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    if (!web.isEmpty()) {
      addWeb(material.get(), problems);
    }
    Optional<CollectedAnswers> collected = collect(material.get(), problems);
    if (collected.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    CollectedAnswers answers = collected.get();
    if (Stream.of(responses, ratings, others, scores, trials, bands).allMatch(Objects::isNull)) {
      console().out().print(answers.responses());
    }
    write(responses, answers.responses());
    write(ratings, answers.ratings());
    write(others, answers.others());
    write(scores, answers.scores());
    write(trials, answers.trials());
    write(bands, answers.bands());
    tell(answers);
    return ExitStatus.of(problems);
  }

  /**
   * Says how many answers there are, in which table, and which option writes the others. Rows of
   * the tables are counted, so that the numbers add up.
   */
  private void tell(CollectedAnswers answers) {
    boolean printed =
        Stream.of(responses, ratings, others, scores, trials, bands).allMatch(Objects::isNull);
    List<String> rows = new ArrayList<>();
    List<String> left = new ArrayList<>();
    tell(answers.responses(), "recognition answers", "--responses", printed, responses, rows, left);
    tell(answers.ratings(), "ratings", "--ratings", false, ratings, rows, left);
    tell(answers.others(), "other answers and the form", "--answers", false, others, rows, left);
    tell(answers.scores(), "scores", "--scores", false, scores, rows, left);
    tell(answers.trials(), "trials", "--trials", false, trials, rows, left);
    if (trials != null && !practice && rows(answers.trials()) == 0) {
      rows.add("trials: 0; those of practice blocks are written with --practice");
    }
    int all =
        Stream.of(answers.responses(), answers.ratings(), answers.others(), answers.trials())
            .mapToInt(ExperimentCollectCommand::rows)
            .sum();
    console()
        .message(
            "collected: %s of %s%s"
                .formatted(
                    Pluralizer.of(all, "answer"),
                    Pluralizer.of(answers.participants(), "participant"),
                    rows.isEmpty()
                        ? ""
                        : " (rows of the tables: " + String.join(", ", rows) + ")"));
    if (!left.isEmpty()) {
      console().message("not written: " + String.join(", ", left));
    }
  }

  private static void tell(
      String table,
      String what,
      String option,
      boolean printed,
      @Nullable Path file,
      List<String> rows,
      List<String> left) {
    int number = rows(table);
    if (number > 0) {
      rows.add(what + ": " + number);
      if (!printed && file == null) {
        left.add("%s (%s F.csv)".formatted(what, option));
      }
    }
  }

  /** Returns the number of rows of a table as CSV, without its header. */
  static int rows(String table) {
    boolean quoted = false;
    int lines = 0;
    for (int i = 0; i < table.length(); i++) {
      quoted ^= table.charAt(i) == '"';
      lines += table.charAt(i) == '\n' && !quoted ? 1 : 0;
    }
    return Math.max(0, lines - 1);
  }

  /** Makes session folders of what browsers sent. */
  private void addWeb(LoadedStudy material, ProblemCollector problems) throws IOException {
    WebSessionImport.Summary made =
        WebSessionImport.run(
            material,
            web,
            ProgramVersion.PROGRAM + " " + ProgramVersion.number(),
            new SceneExposureReplay(),
            problems);
    console()
        .message(
            "from browsers: %s added, %d with more records, %d there already"
                .formatted(
                    Pluralizer.of(made.added(), "session"), made.changed(), made.unchanged()));
  }

  /** Collects the answers of the study, or of all sites; empty if these do not go together. */
  private Optional<CollectedAnswers> collect(LoadedStudy material, ProblemCollector problems)
      throws IOException {
    OptionalInt session = number == null ? OptionalInt.empty() : OptionalInt.of(number);
    if (sites.any()) {
      Optional<StudySites> all = sites.read(material, problems);
      return all.isEmpty()
          ? Optional.empty()
          : Optional.of(SiteTables.collect(all.get(), session, practice, problems));
    }
    return Optional.of(
        CollectedAnswers.of(
            material,
            session,
            practice,
            folder -> true,
            PaperAnswers.read(material, paper.tables(), problems),
            problems));
  }

  private static void write(@Nullable Path file, String text) throws IOException {
    if (file != null) {
      OutputFile.writePrivate(file, text);
    }
  }
}
