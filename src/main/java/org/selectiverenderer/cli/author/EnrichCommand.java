package org.selectiverenderer.cli.author;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.headless.HeadlessEnrichment;
import org.selectiverenderer.authoring.ratings.GazeProposal;
import org.selectiverenderer.authoring.ratings.GazeProposalTable;
import org.selectiverenderer.authoring.ratings.RatingScale;
import org.selectiverenderer.authoring.ratings.ViewedObjects;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.cli.option.DryRunOption;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.option.AccessOptions;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.enricher.ratings.GazeProposals;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "enrich",
    description = {
      "Opens the enricher, the window in which authors say which objects people expect where.",
      "With --ratings, --from-logs or --apply it writes schema metadata into a scene without a"
          + " window. Only metadata changes, everything else stays byte for byte. The previous file"
          + " is kept with the ending .bak.",
      "With --from-logs it prints for each object how consistent it is with its area, by what"
          + " participants looked at, and writes what is clear; --ratings are then what objects"
          + " seen little are taken for."
    },
    footer = {
      "  ./selective-renderer enrich scenes/apartment-plain.x3d",
      "  ./selective-renderer enrich scenes/apartment-plain.x3d \\",
      "      --ratings ratings.csv --dry-run",
      "  ./selective-renderer enrich scenes/apartment-plain.x3d \\",
      "      --from-logs mystudy --dry-run"
    })
public final class EnrichCommand extends CliCommand {
  /** Opens the enricher's window. */
  @FunctionalInterface
  public interface Window {
    /**
     * @param scene to open; empty for none
     * @param access the files and URLs that the scene may load besides those in its folder
     */
    ExitStatus open(Optional<Path> scene, ContentAccessPolicy access) throws IOException;
  }

  private final Window window;

  /** The participants whose logs were used. */
  private int participants;

  @Parameters(
      paramLabel = "SCENE",
      arity = "0..1",
      description = "X3D scene (XML; others with --output)")
  private @Nullable Path scene;

  @Option(
      names = "--apply",
      paramLabel = "METADATA.csv",
      description = "table of the metadata to write, with the columns node,choice,field,value")
  private @Nullable Path metadata;

  @Option(
      names = "--ratings",
      paramLabel = "RATINGS.csv",
      description =
          "table of expectancy ratings (1 to 6) from which the metadata follows, with the "
              + "columns object,schema,rating")
  private @Nullable Path ratings;

  /** How ratings choose among versions, as the option spells it. */
  private enum Scale {
    bands(RatingScale.BANDS),
    linear(RatingScale.LINEAR);

    private final RatingScale scale;

    Scale(RatingScale scale) {
      this.scale = scale;
    }
  }

  @Option(
      names = "--rating-scale",
      paramLabel = "KIND",
      description =
          "how ratings choose among the versions of an object: bands (the thesis's: up to 3 the"
              + " first, from 4 the last) or linear (1 to 6 evenly over the degrees 0 to 1 of all"
              + " versions) (default: bands)")
  private @Nullable Scale scale;

  @Option(
      names = "--from-logs",
      paramLabel = "LOG",
      arity = "1..*",
      description =
          "head logs of participants, or folders of studies or sessions with them, from which the"
              + " consistency of objects is proposed; after SCENE")
  private List<Path> logs = new ArrayList<>();

  @Option(
      names = "--output",
      paramLabel = "OUT.x3d",
      description = "writes the enriched scene to another file")
  private @Nullable Path output;

  @Mixin private AccessOptions access = new AccessOptions();

  @Mixin private DryRunOption dryRun = new DryRunOption();

  public EnrichCommand(Console console, Window window) {
    super(console);
    this.window = window;
  }

  @Override
  public ExitStatus run() throws IOException {
    if (metadata == null && ratings == null && logs.isEmpty()) {
      if (output != null || dryRun.asked()) {
        throw CommandException.usage(
            "--output and --dry-run need --apply, --ratings or --from-logs");
      }
      return window.open(Optional.ofNullable(scene), access.access());
    }
    if (scale != null && ratings == null && logs.isEmpty()) {
      throw CommandException.usage("--rating-scale needs --ratings or --from-logs");
    }
    if (scene == null) {
      throw CommandException.usage(
          "--apply, --ratings and --from-logs need a SCENE; name it first");
    }
    if (!dryRun.asked()) {
      OutputFile.check("--output", output, "");
    }
    Path target = output == null ? scene : output;
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<HeadlessEnrichment> enriched =
        HeadlessEnrichment.of(
            new HeadlessEnrichment.Request(
                scene,
                ratings,
                scale == null ? RatingScale.BANDS : scale.scale,
                metadata,
                logs.isEmpty() ? null : this::proposals,
                target),
            NodeCatalogue.load(),
            problems);
    if (enriched.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    if (!logs.isEmpty()) {
      tell(enriched.get().proposals());
    }
    MissingFilesWarning.tell(enriched.get().leftBehind(target), target, console());
    if (dryRun.asked()) {
      console().out().print(enriched.get().difference(target));
    } else if (output == null && metadata == null && unclear(enriched.get())) {
      console().message(target + ": no proposal is clear enough; nothing is written");
    } else if (enriched.get().changed() || output != null) {
      enriched.get().save(target);
      console().message(target + ": enriched");
    } else {
      console().message(target + ": has all of this metadata already; nothing is written");
    }
    return ExitStatus.of(problems);
  }

  private List<GazeProposal> proposals(ViewedObjects objects, ProblemCollector problems)
      throws IOException {
    String name = scene == null ? "" : String.valueOf(scene.getFileName());
    GazeProposals read = GazeProposals.read(logs, name, problems);
    participants = read.participants();
    return read.of(objects);
  }

  private boolean unclear(HeadlessEnrichment enriched) {
    return !logs.isEmpty() && enriched.proposals().stream().noneMatch(GazeProposal::applicable);
  }

  private void tell(List<GazeProposal> proposals) {
    if (proposals.isEmpty()) {
      console()
          .message(
              participants == 0
                  ? "no log is used, so nothing is proposed"
                  : "in no log was an object of the scene in view for a second");
      return;
    }
    // With --dry-run the difference follows; patch passes over the table before it.
    console().out().print(GazeProposalTable.text(proposals));
    long clear = proposals.stream().filter(GazeProposal::applicable).count();
    console()
        .message(
            "%d of %d proposals are clear enough to be written".formatted(clear, proposals.size()));
  }
}
