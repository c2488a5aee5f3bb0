package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.render.RenderOptions;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.walkthrough.ViewpointFinder;
import org.selectiverenderer.walkthrough.Walkthrough;
import picocli.CommandLine.Option;

/** The options for the viewpoint, the collisions and the drawing style of a scene. */
final class ViewOptions {
  private enum Switched {
    on,
    off
  }

  private enum Place {
    auto,
    vertex,
    pixel
  }

  @Option(
      names = "--viewpoint",
      paramLabel = "NAME",
      description = "viewpoint to begin at, by its DEF name or description")
  private @Nullable String viewpoint;

  @Option(
      names = "--viewpoints",
      description = "lists the viewpoints of the scene, by DEF name and description, and ends")
  private boolean list;

  @Option(
      names = "--headlight",
      paramLabel = "on|off",
      description = "light at the viewer (default: what the scene's NavigationInfo says)")
  private @Nullable Switched headlight;

  @Option(names = "--wireframe", description = "draws only the edges of polygons")
  private boolean wireframe;

  @Option(
      names = "--no-collisions",
      description = "lets the viewer pass through walls at first; F3 switches collisions on")
  private boolean noCollisions;

  @Option(
      names = "--shading",
      paramLabel = "PLACE",
      defaultValue = "auto",
      description =
          "place where light is computed: pixel, vertex (at the corners of polygons where "
              + "that looks the same, which is faster without a graphics card) or auto, which "
              + "chooses by the machine (default: ${DEFAULT-VALUE})")
  private Place shading = Place.auto;

  Optional<String> viewpoint() {
    return Optional.ofNullable(viewpoint);
  }

  boolean collisions() {
    return !noCollisions;
  }

  /** Returns whether the viewpoints are listed instead of a run. */
  boolean listed() {
    return list;
  }

  RenderOptions style() {
    return new RenderOptions(
        ShadingMode.valueOf(shading.name().toUpperCase(Locale.ROOT)),
        Optional.ofNullable(headlight).map(Switched.on::equals),
        wireframe);
  }

  /**
   * Prints a scene's viewpoints, one in a line: DEF name, tab, description.
   *
   * @throws IOException if the scene cannot be read
   */
  static ExitStatus list(Path scene, Console console) throws IOException {
    try (Walkthrough walk =
        Walkthrough.open(
            scene,
            SelectiveController.Settings.SELECTIVE,
            console::problem,
            event -> {},
            text -> {})) {
      List<ViewpointFinder.Entry> all = ViewpointFinder.of(walk.world());
      all.forEach(entry -> console.line((entry.name() + "\t" + entry.description()).strip()));
      console.out().flush();
      if (all.isEmpty()) {
        console.message("the scene has no viewpoints; it is seen from 0 0 10, along -Z");
      }
      return walk.problems().any() ? ExitStatus.PROBLEMS : ExitStatus.DONE;
    }
  }
}
