package org.selectiverenderer.cli.author;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.authoring.file.XmlConversion;
import org.selectiverenderer.authoring.versions.BatchVersionsEdit;
import org.selectiverenderer.authoring.versions.ChangePreview;
import org.selectiverenderer.authoring.versions.ObjectVersion;
import org.selectiverenderer.authoring.versions.PlannedFile;
import org.selectiverenderer.authoring.versions.SceneNotEditableException;
import org.selectiverenderer.authoring.versions.VersionCandidate;
import org.selectiverenderer.authoring.versions.VersionCandidateFinder;
import org.selectiverenderer.authoring.versions.VersionsEdit;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.cli.option.DryRunOption;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.option.AccessOptions;
import org.selectiverenderer.command.option.SceneArgument;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.command.output.UndeletedFilesWarning;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "versions",
    description = {
      "Makes versions of an object, or of all, and puts Switches in their place.",
      "The original becomes version 1; each number asked for makes one more. The "
          + "rest of the scene stays as it is, byte for byte. A second run makes new "
          + "versions from version 1.",
      "--texture-percent and --shading make no further version, but levels of fields that "
          + "the controller sets in the object as it is (docs/qualities.md)."
    },
    footer = {
      "  ./selective-renderer versions docs/examples/music-room.x3d --object Vase \\",
      "      --vert-percent 10 --dry-run",
      "  ./selective-renderer versions docs/examples/qualities/jug.x3d --object Jug \\",
      "      --texture-percent 25 --shading flat --dry-run",
      "  ./selective-renderer versions docs/examples/music-room.x3d --all \\",
      "      --max-error 0.02 --dry-run"
    })
public final class VersionsCommand extends CliCommand {
  /**
   * The first and last lines of removed text that {@code --dry-run} shows, each with at most {@code
   * WIDTH} characters.
   */
  private static final int HEAD = 12;

  private static final int TAIL = 4;
  private static final int WIDTH = 160;

  /** The exclusive options that say which objects get versions. */
  static final class ObjectOptions {
    @Option(
        names = "--object",
        paramLabel = "DEF",
        description = "object, or the Transform or Group around it, by its DEF")
    private String object = "";

    @Option(
        names = "--all",
        description =
            "all whole pieces worth it: no walls, floors, shared nodes and objects that have "
                + "versions; the unnamed get names")
    private boolean all;
  }

  /** The exclusive options for the goals of the reduction. */
  static final class GoalOptions {
    @Option(
        names = "--vert-percent",
        split = ",",
        paramLabel = "P",
        description = "shares of the vertices to keep, in percent, one per version (Vert Percent)")
    private List<Double> vertPercent = List.of();

    @Option(
        names = "--polygons",
        split = ",",
        paramLabel = "N",
        description = "numbers of polygons to keep, one per version")
    private List<Integer> polygons = List.of();

    @Option(
        names = "--max-error",
        split = ",",
        paramLabel = "E",
        description =
            "largest deviations from the original, as shares of its size, one per version: 0.01")
    private List<Double> errors = List.of();

    List<SimplificationTarget> goals() {
      if (!errors.isEmpty()) {
        return errors.stream().map(ReductionGoalOptions::error).toList();
      }
      return polygons.isEmpty()
          ? vertPercent.stream().map(ReductionGoalOptions::percent).toList()
          : polygons.stream().map(ReductionGoalOptions::polygons).toList();
    }
  }

  @Mixin private SceneArgument scene = new SceneArgument();

  @ArgGroup(exclusive = true, multiplicity = "1")
  private ObjectOptions objects = new ObjectOptions();

  @Option(
      names = "--above",
      defaultValue = "" + VersionCandidateFinder.FEW,
      paramLabel = "POLYGONS",
      description =
          "with --all: only objects with at least so many polygons (default: ${DEFAULT-VALUE})")
  private int above = VersionCandidateFinder.FEW;

  @ArgGroup(exclusive = true, multiplicity = "0..1")
  private GoalOptions options = new GoalOptions();

  @Mixin private QualityLevelOptions qualities = new QualityLevelOptions();

  @Option(
      names = "--output",
      paramLabel = "OUT.x3d",
      description = "writes the changed scene to another file")
  private @Nullable Path output;

  @Option(
      names = "--inline-dir",
      defaultValue = "inlineNodes",
      paramLabel = "DIR",
      description =
          "folder of the versions, relative to the scene's folder (default: ${DEFAULT-VALUE})")
  private String inlineFolder = "inlineNodes";

  @Mixin private AccessOptions access = new AccessOptions();

  @Mixin private DryRunOption dryRun = new DryRunOption();

  public VersionsCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    List<SimplificationTarget> goals = options.goals();
    ProblemCollector problems = new ProblemCollector(console()::problem);
    if (goals.isEmpty() == qualities.isEmpty()) {
      throw CommandException.usage(
          goals.isEmpty()
              ? "say what the versions differ in: --vert-percent, --polygons, --max-error,"
                  + " --texture-percent or --shading"
              : "--texture-percent and --shading are a run of their own; make the versions by"
                  + " polygons first, then the levels in their files");
    }
    OutputFile.check("--output", output, ".x3d", ".x3dz");
    VersionsEdit.Request request =
        new VersionsEdit.Request(
                scene.file(),
                objects.object,
                goals,
                output == null ? scene.file() : output,
                inlineFolder)
            .allowing(access.access());
    NodeCatalogue catalogue = NodeCatalogue.load();
    Optional<DocumentFile> file =
        XmlConversion.open(
            scene.file(), request.output(), "versions are written", catalogue, problems);
    if (file.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    if (!qualities.isEmpty()) {
      if (objects.all) {
        throw CommandException.usage("--texture-percent and --shading take an --object, not --all");
      }
      return new QualityLevelWriter(console(), dryRun.asked(), scene.file(), request.output())
          .write(
              file.get(), qualities.request(objects.object), access.access(), catalogue, problems);
    }
    DocumentSnapshot document = file.get().document().snapshot();
    if (objects.all) {
      return all(document, request, goals, catalogue, problems);
    }
    Optional<VersionsEdit> plan;
    try {
      plan = VersionsEdit.plan(document, request, catalogue, problems);
    } catch (SceneNotEditableException e) {
      console().message(e.getMessage());
      return ExitStatus.PROBLEMS;
    }
    if (plan.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    if (!dryRun.asked()) {
      new CommandFileCheck().writes("--output", output).check(request.access().named());
      UndeletedFilesWarning.tell(plan.get().write(), console());
    }
    print(plan.get().object(), plan.get().versions());
    print(plan.get().files(), plan.get().scene(), plan.get().changes());
    return plan.get().versions().stream().allMatch(ObjectVersion::met)
        ? ExitStatus.of(problems)
        : ExitStatus.PROBLEMS;
  }

  /** Makes versions of all objects that are worth it. */
  private ExitStatus all(
      DocumentSnapshot document,
      VersionsEdit.Request request,
      List<SimplificationTarget> goals,
      NodeCatalogue catalogue,
      ProblemCollector problems)
      throws IOException {
    BatchVersionsEdit plan;
    try {
      List<BatchVersionsEdit.Item> items =
          VersionCandidateFinder.find(document, request, List.of(), catalogue, (share, name) -> {})
              .stream()
              .peek(this::explain)
              .filter(object -> object.proposed(above))
              .map(object -> new BatchVersionsEdit.Item(object, goals))
              .toList();
      plan =
          BatchVersionsEdit.plan(
              document, request, items, catalogue, (share, name) -> {}, problems);
    } catch (SceneNotEditableException e) {
      console().message(e.getMessage());
      return ExitStatus.PROBLEMS;
    }
    if (plan.isEmpty()) {
      console().message(scene.file() + ": no object gets versions");
      return ExitStatus.PROBLEMS;
    }
    if (!dryRun.asked()) {
      new CommandFileCheck().writes("--output", output).check(request.access().named());
      UndeletedFilesWarning.tell(plan.write(), console());
    }
    plan.objects().forEach(object -> print(object.name(), object.versions()));
    print(plan.files(), plan.scene(), ChangePreview.of(plan.edit(), document.text()));
    return plan.objects().stream()
            .allMatch(object -> object.versions().stream().allMatch(ObjectVersion::met))
        ? ExitStatus.of(problems)
        : ExitStatus.PROBLEMS;
  }

  /** Tells why an object with enough polygons gets no versions. */
  private void explain(VersionCandidate object) {
    if (object.polygons() < above || object.proposed(above)) {
      return;
    }
    String why =
        switch (object.remark()) {
          case NONE, FEW -> "has few polygons";
          case FLAT -> "is flat and large, as a wall or a floor";
          case AROUND -> "surrounds the scene";
          case SHARED -> "is drawn elsewhere too (USE)";
          case VERSIONS -> "has versions";
          case IMPOSSIBLE -> object.obstacle();
        };
    console()
        .line(
            "skipped  %s (%s): %s"
                .formatted(
                    object.name(), ReductionGoalOptions.polygonText(object.polygons()), why));
  }

  private void print(String object, List<ObjectVersion> versions) {
    int original = versions.get(0).polygons();
    for (ObjectVersion version : versions) {
      console()
          .out()
          .printf(
              Locale.ROOT,
              "%s_v%d  %8d vertices  %8d polygons  %5.1f %%  error %.3f %%%n",
              object,
              version.number(),
              version.vertices(),
              version.polygons(),
              100.0 * version.polygons() / original,
              100 * version.error());
      if (!version.met()) {
        console()
            .message(
                "%s: version %d of '%s' cannot be reduced as far as asked for; %s nearest"
                    .formatted(
                        scene.file(),
                        version.number(),
                        object,
                        ReductionGoalOptions.polygonText(version.polygons())
                            + (version.polygons() == 1 ? " comes" : " come")));
      }
    }
  }

  private void print(List<PlannedFile> files, PlannedFile changed, List<ChangePreview> changes) {
    files.forEach(this::print);
    print(changed);
    if (dryRun.asked()) {
      changes.forEach(this::print);
    }
  }

  private void print(PlannedFile file) {
    String done =
        switch (file.state()) {
          case NEW -> dryRun.asked() ? "would be created" : "new";
          case CHANGED -> dryRun.asked() ? "would change" : "changed";
          case UNCHANGED -> "unchanged";
        };
    console().line(done + "  " + file.file());
  }

  private void print(ChangePreview edit) {
    console().line(scene.file() + ":" + edit.line() + ":");
    shortened(edit.before().lines().toList()).forEach(line -> console().line("- " + line));
    edit.after().lines().forEach(line -> console().line("+ " + line));
  }

  /** Shortens long texts to their first and last lines, because geometry may take megabytes. */
  static List<String> shortened(List<String> lines) {
    List<String> kept = new ArrayList<>();
    for (int i = 0; i < lines.size(); i++) {
      if (i < HEAD || i >= lines.size() - TAIL) {
        String line = lines.get(i);
        kept.add(
            line.length() <= WIDTH
                ? line
                : String.format(
                    Locale.ROOT,
                    "%s ... (%,d characters)",
                    line.substring(0, WIDTH),
                    line.length()));
      } else if (i == HEAD) {
        kept.add("... (" + Pluralizer.of(lines.size() - HEAD - TAIL, "line") + ")");
      }
    }
    return kept;
  }
}
