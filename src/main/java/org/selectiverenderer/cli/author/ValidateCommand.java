package org.selectiverenderer.cli.author;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.base.trust.PermissionRequests;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.ProgramVersion;
import org.selectiverenderer.command.option.AccessOptions;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.command.trust.TrustPrompt;
import org.selectiverenderer.export.ExportRules;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.validation.ValidationReport;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.report.ReportFormat;
import org.selectiverenderer.validation.report.RuleDocumentation;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.SceneFinder;
import org.selectiverenderer.validation.run.Validator;
import org.selectiverenderer.validation.settings.Baseline;
import org.selectiverenderer.validation.settings.ValidationSettingsReader;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.TypeConversionException;

@Command(
    name = "validate",
    description = {
      "Checks scenes and everything that they inline: XML, X3D, geometry, files and "
          + "enrichment.",
      "Exit status: 0 if no finding is as severe as --fail-on, 1 if there are such "
          + "findings, 2 after a failure."
    },
    footer = {
      "  ./selective-renderer validate scenes/",
      "  ./selective-renderer validate --explain SR101"
    })
public final class ValidateCommand extends CliCommand {
  private enum FailOn {
    error,
    warning
  }

  /** Converts the names of report formats. */
  private static final class Formats implements ITypeConverter<ReportFormat> {
    @Override
    public ReportFormat convert(String value) {
      for (ReportFormat format : ReportFormat.values()) {
        if (format.name().equalsIgnoreCase(value)) {
          return format;
        }
      }
      throw new TypeConversionException(
          "'" + value + "' is not a format; choose text, json, sarif, junit or github");
    }
  }

  private final InputStream input;

  @Parameters(
      paramLabel = "PATH",
      description =
          "scenes, folders of scenes, patterns such as 'scenes/*.x3d'; - is standard input")
  private List<String> paths = List.of();

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      defaultValue = "text",
      converter = Formats.class,
      description =
          "format of the report: text, json, sarif, junit or github (default: "
              + "${DEFAULT-VALUE})")
  private ReportFormat format = ReportFormat.TEXT;

  @Option(names = "--output", paramLabel = "F", description = "writes the report into a file")
  private @Nullable Path output;

  @Option(
      names = "--fail-on",
      paramLabel = "SEVERITY",
      defaultValue = "error",
      description =
          "lowest severity that makes the exit status 1: ${COMPLETION-CANDIDATES} "
              + "(default: ${DEFAULT-VALUE})")
  private FailOn failOn = FailOn.error;

  @Option(
      names = "--ignore",
      split = ",",
      paramLabel = "ID",
      description = "rules to ignore, or beginnings of their ids (SR2: all rules on geometry)")
  private List<String> ignored = List.of();

  @Option(
      names = "--config",
      paramLabel = "F",
      description =
          "settings in JSON: rules to ignore, severities, polygon budgets (see "
              + "docs/validate.md)")
  private @Nullable Path config;

  @Option(
      names = "--baseline",
      paramLabel = "F",
      description = "earlier report in JSON, whose findings are not reported again")
  private @Nullable Path baseline;

  @Option(
      names = "--base",
      paramLabel = "DIR",
      description = "folder to which file names in reports are relative (default: the current one)")
  private Path base = Path.of("");

  @Mixin private AccessOptions access = new AccessOptions();

  @Mixin private TrustOption trust = new TrustOption();

  @Option(
      names = "--for-export",
      description = "also says what the command export cannot carry (rules SR801 and SR802)")
  private boolean forExport;

  @Option(names = "--rules", description = "lists all rules")
  private boolean rules;

  @Option(names = "--explain", paramLabel = "ID", description = "explains a rule, with examples")
  private @Nullable String explained;

  public ValidateCommand(Console console, InputStream input) {
    super(console);
    this.input = input;
  }

  @Override
  public ExitStatus run() throws IOException {
    RuleCatalogue standard = RuleCatalogue.standard();
    // Explained and ignored like all others, but checked on demand.
    RuleCatalogue catalogue = standard.with(ExportRules.group());
    if ((rules || explained != null) && !paths.isEmpty()) {
      throw CommandException.usage(
          (rules ? "--rules" : "--explain") + " lists or explains rules; it takes no PATH");
    }
    if (rules || explained != null) {
      print(
          explained == null
              ? new RuleDocumentation(catalogue).list()
              : explain(catalogue, explained),
          false);
      return ExitStatus.DONE;
    }
    OutputFile.check("--output", output, "");
    Severity least = failOn == FailOn.error ? Severity.ERROR : Severity.WARNING;
    Optional<ValidationSettings> settings = settings(catalogue);
    if (settings.isEmpty()) {
      return ExitStatus.FAILURE;
    }
    Baseline old = baseline == null ? Baseline.none() : Baseline.read(baseline);
    ValidationReport report =
        old.without(
            new Validator(forExport ? catalogue : standard, settings.get(), base)
                .validate(files()));
    CommandFileCheck written =
        new CommandFileCheck()
            .reads("--config", config)
            .reads("--baseline", baseline)
            .writes("--output", output);
    report.files().stream()
        .filter(file -> file.inMemory() == null)
        .forEach(file -> written.reads("", file.path()));
    written.check(); // Before it is written: Inlines are known now only.
    written.check(settings.get().access().named());
    boolean colours = console().colours() && output == null;
    print(
        format.write(report, new ReportFormat.Style(colours, least, ProgramVersion.number())),
        colours && format == ReportFormat.TEXT);
    // When findings were dropped, they cannot be compared with the baseline.
    boolean unjudged = baseline != null && report.dropped() > 0;
    return unjudged || report.has(least) ? ExitStatus.PROBLEMS : ExitStatus.DONE;
  }

  private Optional<ValidationSettings> settings(RuleCatalogue catalogue) throws IOException {
    Set<String> more = new HashSet<>();
    for (String id : ignored) {
      more.add(catalogue.resolve(id).orElseThrow(() -> unknown(catalogue, "--ignore", id)));
    }
    Optional<ValidationSettings> settings =
        config == null
            ? Optional.of(ValidationSettings.standard())
            : new ValidationSettingsReader(config, catalogue)
                .read(new ProblemCollector(console()::problem));
    if (config != null && settings.isPresent()) {
      PermissionRequests asked = settings.get().permissions();
      trust.require(config, asked, TrustPrompt.onTerminal(console()), console());
    }
    return settings.map(read -> read.ignoring(more).allowing(read.access().and(access.access())));
  }

  private List<SourceFile> files() throws IOException {
    if (paths.isEmpty()) {
      throw CommandException.usage("no PATH given; name a scene or a folder of scenes");
    }
    if (!Files.isDirectory(base)) {
      throw CommandException.usage("--base " + base + ": is not a folder");
    }
    SceneFinder finder = new SceneFinder(base, input);
    List<SourceFile> files = new ArrayList<>();
    for (String path : paths) {
      files.addAll(finder.find(path));
    }
    return files;
  }

  private static String explain(RuleCatalogue catalogue, String id) {
    return RuleDocumentation.explain(
        catalogue.find(id).orElseThrow(() -> unknown(catalogue, "--explain", id)));
  }

  private static CommandException unknown(RuleCatalogue catalogue, String option, String id) {
    return CommandException.usage(
        option
            + ": there is no rule '"
            + id
            + "'"
            + SpellingSuggester.nearest(id, catalogue.rules().stream().map(Rule::id).toList())
                .map(near -> "; did you mean " + near + "?")
                .orElse("; --rules lists them"));
  }

  private void print(String text, boolean coloured) throws IOException {
    if (output == null && coloured) {
      console().coloured(text); // The writer has escaped what is not its own.
    } else if (output == null) {
      console().out().print(text);
      console().out().flush();
    } else {
      OutputFile.write(output, text);
    }
  }
}
