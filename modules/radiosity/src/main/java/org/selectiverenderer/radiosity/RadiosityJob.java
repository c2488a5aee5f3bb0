package org.selectiverenderer.radiosity;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.radiosity.bake.LightingResult;
import org.selectiverenderer.radiosity.bake.LightmapImageSet;
import org.selectiverenderer.radiosity.bake.LightmappedScene;
import org.selectiverenderer.radiosity.bake.VertexLitScene;
import org.selectiverenderer.radiosity.output.HighlightLightWriter;
import org.selectiverenderer.radiosity.output.LightmapFormat;
import org.selectiverenderer.radiosity.output.LitSceneFormat;
import org.selectiverenderer.radiosity.output.LitSceneWriter;
import org.selectiverenderer.radiosity.output.OutputCollisionGuard;
import org.selectiverenderer.radiosity.output.VertexColorFormat;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.preview.PreviewCamera;
import org.selectiverenderer.radiosity.preview.PreviewRenderer;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.scene.RadiositySceneBuilder;
import org.selectiverenderer.radiosity.solve.EnergyBalance;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * One run of the radiosity command: reads a scene file, computes its light and writes the lit
 * scene, all files or none.
 *
 * @param scene the scene file to light; it is not changed
 * @param access the content that the scene may load besides its own files
 * @param output the file of the lit scene
 * @param inlines the folder for the files that the lit scene inlines
 * @param preview a PNG file that shows the first viewpoint after every iteration, or null
 */
public record RadiosityJob(
    Path scene,
    ContentAccessPolicy access,
    Path output,
    Path inlines,
    @Nullable Path preview,
    RadiositySettings settings) {
  private static final String LIT = "-lit";
  private static final String UNLIT = "-unlit";

  /**
   * Share of the light that leaves the scene above which its author is told that it is open,
   * percent.
   */
  private static final double OPEN = 30;

  /**
   * The result of a run, as the command reports it.
   *
   * @param triangles number of triangles that were lit, versions included
   * @param facets number of facets that carry light, versions included
   * @param vertices number of vertices at which light is stored; 0 if it is in lightmaps
   * @param files number of X3D files written
   * @param complete whether the work ran to its end without being cancelled
   * @param pictures summary of the lightmaps; null if light is stored at vertices
   */
  public record Report(
      int triangles,
      int facets,
      int vertices,
      int patches,
      int lamps,
      double lumens,
      EnergyBalance balance,
      long rays,
      int files,
      boolean complete,
      @Nullable LightmapReport pictures) {}

  /** The loaded scene and what is derived from it. */
  private record LoadedJob(
      LoadedScene loaded, InstanceTree tree, RadiosityScene light, ProblemCollector problems) {}

  /** Creates a job for a scene that may load its own files only. */
  public RadiosityJob(
      Path scene, Path output, Path inlines, @Nullable Path preview, RadiositySettings settings) {
    this(scene, ContentAccessPolicy.none(), output, inlines, preview, settings);
  }

  /**
   * Returns the default file of a scene's lit copy: {@code room.x3d} gives {@code room-lit.x3d}.
   */
  public static Path outputOf(Path scene) {
    return scene.resolveSibling(stem(scene) + LIT + ".x3d");
  }

  /**
   * Returns the default folder for inlined files: in the folder {@code inlineNodes} beside the
   * scene's own folder, which the scene may name, or else beside the scene.
   */
  public static Path inlinesOf(Path output) {
    Path folder = output.toAbsolutePath().normalize().getParent();
    String stem = String.valueOf(output.getFileName()).replaceFirst("\\.[^.]*$", "");
    Path above = folder == null ? null : folder.getParent();
    if (above != null && Files.isDirectory(above.resolve("inlineNodes"))) {
      return above.resolve("inlineNodes").resolve(stem);
    }
    return output.resolveSibling(stem + "-nodes");
  }

  private static String stem(Path scene) {
    String stem = String.valueOf(scene.getFileName()).replaceFirst("\\.[^.]*$", "");
    return stem.endsWith(UNLIT) ? stem.substring(0, stem.length() - UNLIT.length()) : stem;
  }

  /**
   * Runs the job. If it is cancelled, the last complete iteration is written, and nothing before
   * the first one is complete.
   *
   * @param iterations receives the energy balance of each iteration and the requested quality in
   *     percent
   * @throws IOException if a file cannot be read or written; the message is one line
   * @throws RadiosityException if the scene cannot be lit, before the long work, or if it is
   *     cancelled before the first iteration is complete
   */
  public Report run(
      ProblemCollector problems,
      RadiosityProgress progress,
      BiConsumer<EnergyBalance, Double> iterations)
      throws IOException, RadiosityException {
    try (SceneLoader loader =
        new SceneLoader(
            NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), access, problems)) {
      LoadedScene loaded = loader.load(scene);
      InstanceTree tree = new InstanceTree((GroupingNode) loaded.scene().root(), loaded.assets());
      if (tree.root().children().isEmpty() && hasError(problems)) {
        throw RadiosityException.unread();
      }
      new OutputCollisionGuard(scene, tree, access.named()).stay(output, inlines, preview);
      progress.at(RadiosityProgress.Stage.READING, 0.5);
      RadiosityScene lightScene =
          new RadiositySceneBuilder(settings.photometric(), problems)
              .read(tree, loaded.scene().unitLength());
      progress.at(RadiosityProgress.Stage.READING, 1);
      return light(new LoadedJob(loaded, tree, lightScene, problems), progress, iterations);
    }
  }

  private Report light(
      LoadedJob work, RadiosityProgress progress, BiConsumer<EnergyBalance, Double> iterations)
      throws IOException, RadiosityException {
    double unit = work.loaded().scene().unitLength();
    PreviewRenderer picture =
        preview == null
            ? null
            : new PreviewRenderer(work.light(), PreviewCamera.of(work.tree(), unit));
    Consumer<RadiositySolution> each =
        solution -> {
          iterations.accept(solution.last(), settings.quality());
          show(picture, shown -> shown.of(solution, settings.exposure()));
        };
    if (!settings.store().inTextures()) {
      TextureDiagnostics.atVertices(work.light(), work.problems());
      VertexLitScene lit = new VertexLightBaker(settings, progress).light(work.light(), each);
      show(picture, shown -> shown.of(lit));
      int files = write(work, new VertexColorFormat(lit), progress, "colours").texts();
      return report(work, lit, lit.facets().vertices(), files, null);
    }
    TextureDiagnostics.inPictures(work.light(), work.problems());
    LightmappedScene lit =
        new LightmapBaker(settings, progress, work.problems())
            .light(
                work.light(),
                LightmapFormat.files(work.light()),
                each,
                picture == null
                    ? null
                    : (pages, curve) -> show(picture, shown -> shown.of(pages, curve)));
    show(picture, shown -> shown.of(lit.pages(), lit.curve()));
    LightmapImageSet painted = LightmapImageSet.of(lit);
    if (settings.store().highlights()) {
      TextureDiagnostics.withoutHighlights(work.light(), painted.use(), work.problems());
    }
    HighlightLightWriter lamps =
        new HighlightLightWriter(lit.curve(), settings.photometric(), unit);
    LightmapFormat form = new LightmapFormat(lit, painted, lamps, settings.store().highlights());
    Written written = write(work, form, progress, "pictures");
    LightmapReport pictures =
        LightmapReport.of(lit, written.pictures(), painted.use().apart(), form.shining());
    return report(work, lit, 0, written.texts(), pictures);
  }

  private Report report(
      LoadedJob work,
      LightingResult lit,
      int vertices,
      int files,
      @Nullable LightmapReport pictures) {
    EnergyBalance balance = lit.solution().last();
    if (balance.escaped() * 100 > OPEN * balance.emitted()) {
      work.problems()
          .info(
              SourceLocation.of(scene.toString()),
              "the scene is open: %.0f percent of its light leaves it"
                  .formatted(100 * balance.escaped() / balance.emitted()));
    }
    return new Report(
        work.light().triangles().count(),
        lit.polygons(),
        vertices,
        lit.solution().patches().count(),
        work.light().lamps().size(),
        work.light().lumens(),
        balance,
        lit.rays(),
        files,
        lit.complete(),
        pictures);
  }

  private static boolean hasError(ProblemCollector problems) {
    return problems.list().stream()
        .anyMatch(problem -> problem.severity() == Problem.Severity.ERROR);
  }

  /**
   * @param pictures size of each image file, bytes
   */
  private record Written(int texts, List<Integer> pictures) {}

  /**
   * @param where the place of the light for the file's description: colours or pictures
   */
  private Written write(
      LoadedJob work, LitSceneFormat form, RadiosityProgress progress, String where)
      throws IOException {
    progress.at(RadiosityProgress.Stage.WRITING, 0);
    Map<Path, String> texts =
        new LitSceneWriter(work.light(), form, output, inlines, work.problems())
            .write(
                work.loaded().scene(),
                work.tree(),
                "Lit by radiosity, from " + scene.getFileName() + "; light is in the " + where);
    progress.at(RadiosityProgress.Stage.WRITING, 0.3);
    Map<Path, byte[]> pictures = form.pictures();
    progress.at(RadiosityProgress.Stage.WRITING, 0.8);
    FileTransaction writing = new FileTransaction();
    texts.forEach((file, text) -> writing.add(file, text.getBytes(StandardCharsets.UTF_8)));
    pictures.forEach(writing::add);
    writing.commit();
    progress.at(RadiosityProgress.Stage.WRITING, 1);
    return new Written(
        texts.size(), pictures.values().stream().map(bytes -> bytes.length).toList());
  }

  /**
   * Overwrites the preview in place, so that an image viewer that has it open shows the new one.
   */
  private void show(@Nullable PreviewRenderer picture, Function<PreviewRenderer, byte[]> png) {
    if (preview != null && picture != null) {
      try {
        AtomicFileWriter.writeInto(preview, png.apply(picture));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }
}
