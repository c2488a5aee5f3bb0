package org.selectiverenderer.radiosity.atlas;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.MemoryEstimator;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/**
 * Builds the {@link Atlas} of a scene: cuts bodies into charts, sizes the charts, packs them on
 * pages and finds the surface point of each texel.
 */
public final class AtlasBuilder {
  /** The group of a body that gets no page. */
  public static final int NO_GROUP = -1;

  /** Lowest density as a share of the requested one; coarser light is not worth storing. */
  private static final double LEAST = 1.0 / 16;

  /** Factor by which the density is lowered until the pages keep the budget. */
  private static final double LOWER = 0.95;

  /** Share of a page's texels that charts and gutters fill, approximately. */
  private static final double FILLED = 0.9;

  private final AtlasSettings settings;
  private final ProblemCollector problems;

  /**
   * @param problems receives a note for each surface that is stored coarser than requested
   */
  public AtlasBuilder(AtlasSettings settings, ProblemCollector problems) {
    this.settings = settings;
    this.problems = problems;
  }

  /**
   * Builds the atlas; the same scene gives the same atlas on any number of processors.
   *
   * @param groupOf by body: the number of the file that it is written to, 0 or above; {@link
   *     #NO_GROUP} for bodies without light of their own, whose layouts have page -1 and no
   *     coordinates
   * @throws RadiosityException if the atlas exceeds the budget or Java's memory
   */
  public Atlas make(RadiosityScene scene, int[] groupOf) throws RadiosityException {
    return make(scene, groupOf, new double[scene.bodies().size()]);
  }

  /**
   * Builds an atlas in which some bodies have as many texels as their own textures need.
   *
   * @param wished by body: the number of texels from which on its own texture can be merged into
   *     its lightmap; 0 for none. A body gets that number or, where that is far finer than
   *     otherwise or too much for the budget, the number that it would have without
   */
  public Atlas make(RadiosityScene scene, int[] groupOf, double[] wished)
      throws RadiosityException {
    int count = scene.bodies().size();
    @Nullable UvCharts[] charts = new UvCharts[count];
    IntStream.range(0, count)
        .parallel()
        .filter(i -> groupOf[i] >= 0)
        .forEach(i -> charts[i] = UvCharts.of(new TriangleAdjacency(scene, scene.bodies().get(i))));
    ChartRectangles boxes = new ChartRectangles(charts);
    AtlasPacker planner = new AtlasPacker(boxes, settings.largestPage());
    double[] densities = TexelDensity.of(scene, settings);
    boolean[] bounded = new boolean[count];
    Map<Integer, List<Integer>> groups = new TreeMap<>();
    for (int i = 0; i < count; i++) {
      if (groupOf[i] >= 0) {
        groups.computeIfAbsent(groupOf[i], key -> new ArrayList<>()).add(i);
        bounded[i] = bound(scene.bodies().get(i), i, boxes, planner, densities);
      }
    }
    List<AtlasPacker.Page> pages =
        finer(groups, boxes, planner, TexelDensity.finer(densities, wished, charts, boxes, planner))
            .orElse(null);
    if (pages == null) {
      pages = withinBudget(groups, boxes, planner, densities);
    }
    MemoryEstimator.ofTexels(pages.stream().mapToLong(AtlasPacker.Page::texels).sum());
    for (int i = 0; i < count; i++) {
      if (bounded[i]) {
        problems.info(
            scene.bodies().get(i).shape().node().location(),
            "the shape is too large for its light to be stored finer than %s texels per metre"
                .formatted(digits(densities[i])));
      }
    }
    return draw(scene, charts, boxes, pages);
  }

  /** Lowers a body's density until it fits on one page; returns whether that was needed. */
  private static boolean bound(
      Body of, int body, ChartRectangles boxes, AtlasPacker planner, double[] densities)
      throws RadiosityException {
    boolean bounded = false;
    while (!planner.fits(body, boxes.size(body, densities[body]))) {
      if (boxes.least(body)) {
        throw new RadiosityException(
            ("%s: the shape is cut into %d charts, more than one lightmap page holds; divide it"
                    + " into several shapes, or use --store vertices")
                .formatted(of.shape().node().location(), boxes.end(body) - boxes.first(body)));
      }
      densities[body] *= LOWER;
      bounded = true;
    }
    return bounded;
  }

  /**
   * Returns the pages with the finer densities; empty if no density is finer or the pages exceed
   * the budget.
   */
  private Optional<List<AtlasPacker.Page>> finer(
      Map<Integer, List<Integer>> groups,
      ChartRectangles boxes,
      AtlasPacker planner,
      Optional<double[]> densities) {
    if (densities.isEmpty()) {
      return Optional.empty();
    }
    long[] texels = new long[densities.get().length];
    for (List<Integer> bodies : groups.values()) {
      bodies.forEach(body -> texels[body] = boxes.size(body, densities.get()[body]));
    }
    return Optional.ofNullable(pages(groups, planner, texels))
        .filter(
            made ->
                made.stream().mapToLong(AtlasPacker.Page::texels).sum()
                    <= settings.budgetBytes() / AtlasSettings.BYTES_PER_TEXEL);
  }

  private List<AtlasPacker.Page> withinBudget(
      Map<Integer, List<Integer>> groups,
      ChartRectangles boxes,
      AtlasPacker planner,
      double[] densities)
      throws RadiosityException {
    double[] wished = densities.clone();
    long most = settings.budgetBytes() / AtlasSettings.BYTES_PER_TEXEL;
    double least = settings.texelsPerMetre().isPresent() ? 1 : LEAST;
    double scale = 1;
    while (true) {
      long[] texels = new long[densities.length];
      long sum = 0;
      for (List<Integer> bodies : groups.values()) {
        for (int body : bodies) {
          densities[body] = scale * wished[body];
          texels[body] = boxes.size(body, densities[body]);
          sum += texels[body];
        }
      }
      boolean last = scale <= least;
      if (sum / FILLED <= most || last && sum <= most) {
        List<AtlasPacker.Page> pages = pages(groups, planner, texels);
        long planned = pages == null ? 0 : pages.stream().mapToLong(AtlasPacker.Page::texels).sum();
        if (pages != null && planned <= most) {
          return pages;
        }
        sum = Math.max(sum, planned);
      }
      if (last) {
        throw new RadiosityException(tooSmall(sum));
      }
      scale = Math.max(least, scale * LOWER);
    }
  }

  /** Packs the bodies of each file; returns null if a body does not fit on a page. */
  private static @Nullable List<AtlasPacker.Page> pages(
      Map<Integer, List<Integer>> groups, AtlasPacker planner, long[] texels) {
    List<AtlasPacker.Page> pages = new ArrayList<>();
    for (List<Integer> bodies : groups.values()) {
      List<AtlasPacker.Page> own = planner.plan(bodies, texels);
      if (own == null) {
        return null;
      }
      pages.addAll(own);
    }
    return pages;
  }

  private String tooSmall(long texels) {
    String needed =
        "light in textures takes %s MB"
            .formatted(megabytes(texels * AtlasSettings.BYTES_PER_TEXEL));
    String budget = ", more than the budget of " + megabytes(settings.budgetBytes()) + " MB; ";
    return settings.texelsPerMetre().isPresent()
        ? needed
            + " at %s texels per metre".formatted(digits(settings.texelsPerMetre().getAsDouble()))
            + budget
            + "lower --texels-per-metre or raise --texture-budget"
        : needed + " even at the least density" + budget + "raise --texture-budget";
  }

  private static Atlas draw(
      RadiosityScene scene,
      @Nullable UvCharts[] charts,
      ChartRectangles boxes,
      List<AtlasPacker.Page> pages) {
    AtlasPage[] maps = new AtlasPage[pages.size()];
    Atlas.Layout[] layouts = new Atlas.Layout[charts.length];
    Arrays.fill(layouts, new Atlas.Layout(AtlasPage.NONE, new float[0]));
    IntStream.range(0, maps.length)
        .parallel()
        .forEach(
            i -> {
              AtlasPacker.Page page = pages.get(i);
              Rasterizer rasterizer = new Rasterizer(page.width(), page.height());
              for (int body : page.bodies()) {
                float[] st =
                    draw(
                        scene.bodies().get(body),
                        charts[body],
                        boxes,
                        boxes.first(body),
                        rasterizer,
                        page);
                layouts[body] = new Atlas.Layout(i, st);
              }
              maps[i] = rasterizer.map();
            });
    return new Atlas(List.of(maps), List.of(layouts));
  }

  private static float[] draw(
      Body body,
      UvCharts charts,
      ChartRectangles boxes,
      int firstBox,
      Rasterizer rasterizer,
      AtlasPacker.Page page) {
    float[] st = new float[6 * body.triangles()];
    double[] p = new double[6];
    for (int i = 0; i < body.triangles(); i++) {
      int chart = charts.chartOf()[i];
      int box = firstBox + chart;
      for (int at = 0; at < 6; at += 2) {
        p[at] = boxes.column(box, charts, chart, 6 * i + at);
        p[at + 1] = boxes.row(box, charts, chart, 6 * i + at);
        st[6 * i + at] = (float) (p[at] / page.width());
        st[6 * i + at + 1] = (float) (p[at + 1] / page.height());
      }
      rasterizer.draw(body.firstTriangle() + i, box, boxes, p);
    }
    return st;
  }

  private static String megabytes(long bytes) {
    double megabytes = bytes / (double) (1 << 20);
    return String.format(Locale.ROOT, megabytes < 1 ? "%.3f" : "%.1f", megabytes);
  }

  private static String digits(double value) {
    return String.format(Locale.ROOT, "%.3g", value);
  }
}
