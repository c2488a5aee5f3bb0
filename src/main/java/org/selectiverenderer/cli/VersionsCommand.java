package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.polygon.simplify.Goal;
import org.selectiverenderer.polygon.versions.BadSceneException;
import org.selectiverenderer.polygon.versions.FileActions;
import org.selectiverenderer.polygon.versions.Version;
import org.selectiverenderer.polygon.versions.VersionMaker;
import org.selectiverenderer.polygon.versions.VersionPlan;
import org.selectiverenderer.x3d.Counted;
import org.selectiverenderer.x3d.NodeCatalogue;
import org.selectiverenderer.x3d.Problems;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "versions",
    description = {
      "Makes versions of an object and puts a Switch in its place.",
      "The original becomes version 1; each number asked for makes one more. The rest of the scene"
          + " stays as it is, byte for byte. Run again, it makes new versions from version 1."
    },
    footer = "  ./selective-renderer versions scene.x3d --object Vase --vert-percent 10 --dry-run")
final class VersionsCommand extends CliCommand {
  /** Of what is removed, --dry-run shows so many lines at most, each of so many characters. */
  private static final int HEAD = 12;

  private static final int TAIL = 4;
  private static final int WIDTH = 160;

  /** One of the ways to say how far to reduce. */
  static final class GoalOptions {
    @Option(
        names = "--vert-percent",
        split = ",",
        paramLabel = "P",
        description = "percents of the vertices (Vert Percent)")
    private List<Double> vertPercent = List.of();

    @Option(
        names = "--polygons",
        split = ",",
        paramLabel = "N",
        description = "numbers of polygons")
    private List<Integer> polygons = List.of();

    List<Goal> goals() {
      return polygons.isEmpty()
          ? vertPercent.stream().map(GoalText::percent).toList()
          : polygons.stream().map(GoalText::polygons).toList();
    }
  }

  @Parameters(paramLabel = "SCENE", description = "the X3D scene (.x3d, .x3dz)")
  private Path scene = Path.of("");

  @Option(
      names = "--object",
      required = true,
      paramLabel = "DEF",
      description = "the object, or the Transform or Group round it")
  private String object = "";

  @ArgGroup(exclusive = true, multiplicity = "1")
  private GoalOptions options = new GoalOptions();

  @Option(
      names = "--output",
      paramLabel = "OUT.x3d",
      description = "writes the changed scene to another file")
  private @Nullable Path output;

  @Option(
      names = "--inline-dir",
      defaultValue = "inlineNodes",
      paramLabel = "DIR",
      description = "for the versions, from the scene's folder (default: ${DEFAULT-VALUE})")
  private String inlineFolder = "inlineNodes";

  @Option(names = "--dry-run", description = "prints what would change and writes nothing")
  private boolean dryRun;

  VersionsCommand(Console console) {
    super(console);
  }

  @Override
  ExitStatus run() throws IOException {
    List<Goal> goals = options.goals();
    Problems problems = new Problems(console()::problem);
    OutputFile.check("--output", output, ".x3d", ".x3dz");
    VersionMaker.Request request =
        new VersionMaker.Request(
            scene, object, goals, output == null ? scene : output, inlineFolder);
    Optional<VersionPlan> plan;
    try {
      plan = new VersionMaker(NodeCatalogue.load()).plan(request, problems);
    } catch (BadSceneException e) {
      console().message(e.getMessage());
      return ExitStatus.PROBLEMS;
    }
    if (plan.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    if (!dryRun) {
      LeftFiles.tell(plan.get().apply(FileActions.REAL), console());
    }
    print(plan.get());
    return plan.get().versions().stream().allMatch(Version::met)
        ? ExitStatus.of(problems)
        : ExitStatus.PROBLEMS;
  }

  private void print(VersionPlan plan) {
    int original = plan.versions().get(0).polygons();
    for (Version version : plan.versions()) {
      console()
          .out()
          .printf(
              Locale.ROOT,
              "%s_v%d  %8d vertices  %8d polygons  %5.1f %%  error %.3f %%%n",
              plan.object(),
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
                        scene,
                        version.number(),
                        object,
                        GoalText.polygonText(version.polygons())
                            + (version.polygons() == 1 ? " comes" : " come")));
      }
    }
    for (VersionPlan.PlannedFile file : plan.files()) {
      String done =
          switch (file.state()) {
            case NEW -> dryRun ? "would be new" : "new";
            case CHANGED -> dryRun ? "would change" : "changed";
            case UNCHANGED -> "unchanged";
          };
      console().out().println(done + "  " + file.file());
    }
    if (dryRun) {
      plan.edits().forEach(this::print);
    }
  }

  private void print(VersionPlan.Edit edit) {
    console().out().println(scene + ":" + edit.line() + ":");
    shortened(edit.before().lines().toList()).forEach(line -> console().out().println("- " + line));
    edit.after().lines().forEach(line -> console().out().println("+ " + line));
  }

  /** Geometry may be megabytes: its beginning and end tell which it is. */
  private static List<String> shortened(List<String> lines) {
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
        kept.add("... (" + Counted.of(lines.size() - HEAD - TAIL, "line") + ")");
      }
    }
    return kept;
  }
}
