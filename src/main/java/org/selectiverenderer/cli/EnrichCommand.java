package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.document.headless.HeadlessEnrichment;
import org.selectiverenderer.x3d.NodeCatalogue;
import org.selectiverenderer.x3d.Problems;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "enrich",
    description = {
      "Writes schema metadata into a scene.",
      "With --ratings or --apply without a window. The rest of the scene stays as it is, byte for"
          + " byte; the file as it was is kept beside it with the ending .bak."
    },
    footer =
        "  ./selective-renderer enrich scenes/apartment-plain.x3d --ratings ratings.csv --dry-run")
final class EnrichCommand extends CliCommand {
  /** Opens the enricher's window. */
  @FunctionalInterface
  interface Window {
    /**
     * @param scene to open; empty for none
     */
    ExitStatus open(Optional<Path> scene) throws IOException;
  }

  private final Window window;

  @Parameters(paramLabel = "SCENE", arity = "0..1", description = "the X3D scene (.x3d, .x3dz)")
  private @Nullable Path scene;

  @Option(
      names = "--apply",
      paramLabel = "METADATA.csv",
      description = "says it: node,choice,field,value")
  private @Nullable Path metadata;

  @Option(
      names = "--ratings",
      paramLabel = "RATINGS.csv",
      description = "expectancy ratings, 1 to 6, that imply it: object,schema,rating")
  private @Nullable Path ratings;

  @Option(
      names = "--output",
      paramLabel = "OUT.x3d",
      description = "writes the enriched scene to another file")
  private @Nullable Path output;

  @Option(names = "--dry-run", description = "prints what would change and writes nothing")
  private boolean dryRun;

  EnrichCommand(Console console, Window window) {
    super(console);
    this.window = window;
  }

  @Override
  ExitStatus run() throws IOException {
    if (metadata == null && ratings == null) {
      if (output != null || dryRun) {
        throw CommandFailure.usage("--output and --dry-run go with --apply or --ratings");
      }
      return window.open(Optional.ofNullable(scene));
    }
    if (scene == null) {
      throw CommandFailure.usage("--apply and --ratings need a SCENE");
    }
    if (!dryRun) {
      OutputFile.check("--output", output, "");
    }
    Path target = output == null ? scene : output;
    Problems problems = new Problems(console()::problem);
    Optional<HeadlessEnrichment> enriched =
        HeadlessEnrichment.of(
            new HeadlessEnrichment.Request(scene, ratings, metadata),
            NodeCatalogue.load(),
            problems);
    if (enriched.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    if (dryRun) {
      console().out().print(enriched.get().difference(target));
    } else if (enriched.get().changed() || output != null) {
      enriched.get().save(target);
      console().message(target + ": enriched");
    } else {
      console().message(target + ": says all this already; nothing to write");
    }
    return ExitStatus.of(problems);
  }
}
