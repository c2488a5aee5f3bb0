package org.selectiverenderer.radiosity.bake;

import java.util.BitSet;
import java.util.concurrent.atomic.LongAdder;
import org.selectiverenderer.radiosity.mesh.RadiosityMesh;
import org.selectiverenderer.radiosity.parallel.ParallelFor;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.sampling.CosineHemisphereSampler;
import org.selectiverenderer.radiosity.sampling.SobolPointSet;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.radiosity.texel.TwoSidedLightSelector;

/**
 * Gathers irradiance at vertices. A vertex stands for the facets around it: rays start all over
 * them, densest at the vertex, so its value is the mean that interpolation between vertices needs,
 * and a vertex in a corner or inside of a wall gets the light of its surroundings. All vertices use
 * the same sample points and directions, so that the remaining error changes slowly along a surface
 * instead of speckling it.
 *
 * <p>Several rays leave each start point. Start points inside of a solid, whose rays meet surfaces
 * from behind, do not count, nor do start points that furniture covers closely: nobody sees them,
 * and interpolation would carry their darkness to visible places. A vertex without any other start
 * point takes the light of its neighbours.
 */
public final class VertexGatherer {
  /** Number of vertices in a parallel task: few, so that cancelling does not wait long. */
  private static final int CHUNK = 32;

  /** Largest number of facets sampled around one vertex. */
  private static final int MOST_FACETS = 16;

  /** Number of start points of rays around a vertex. */
  private static final int STARTS = 16;

  private final RadiosityScene scene;
  private final RadiositySolution solution;
  private final TwoSidedLightSelector sides;
  private final RadiosityMesh facets;
  private final RadiosityMesh.Corners corners;
  private final BitSet divided;
  private final Samples samples;
  private final Samples dividedSamples;

  /**
   * The sampling effort for a vertex.
   *
   * @param rays number of rays for a vertex of an object
   * @param dividedRays number of rays for a vertex of a divided surface, where errors show as
   *     blotches
   * @param lampEvery one in this many rays is accompanied by shadow rays to the lamps
   * @param regather whether indirect light is gathered by rays, or taken from the patches
   */
  public record Effort(int rays, int dividedRays, int lampEvery, boolean regather, int seed) {}

  /**
   * The point sets that all vertices share.
   *
   * @param perStart number of rays from one start point
   */
  record Samples(
      CosineHemisphereSampler directions,
      SobolPointSet starts,
      SobolPointSet lamps,
      int perStart,
      int lampEvery,
      boolean regather) {
    static Samples of(int rays, Effort effort) {
      return new Samples(
          new CosineHemisphereSampler(new SobolPointSet(rays, effort.seed(), 10)),
          new SobolPointSet(rays, effort.seed(), 11),
          new SobolPointSet(rays, effort.seed(), 12),
          Math.max(1, rays / STARTS),
          effort.lampEvery(),
          effort.regather());
    }

    int rays() {
      return directions.size();
    }
  }

  /**
   * @param sides which side of two-sided surfaces is lit
   */
  public VertexGatherer(
      RadiosityScene scene,
      RadiositySolution solution,
      TwoSidedLightSelector sides,
      RadiosityMesh facets,
      Effort effort) {
    this.scene = scene;
    this.solution = solution;
    this.sides = sides;
    this.facets = facets;
    this.corners = facets.cornersByVertex();
    this.divided = facets.ofDividedBodies();
    this.samples = Samples.of(effort.rays(), effort);
    this.dividedSamples = Samples.of(effort.dividedRays(), effort);
  }

  /**
   * Gathers the irradiance at all vertices. If the work is cancelled, the irradiance of the
   * solution's patches is taken instead.
   */
  public VertexLight gather(RadiosityProgress progress, RadiosityProgress.Stage stage) {
    float[] irradiance = new float[3 * facets.vertices()];
    boolean[] valid = new boolean[facets.vertices()];
    LongAdder rays = new LongAdder();
    boolean complete =
        ParallelFor.run(
            facets.vertices(),
            CHUNK,
            progress,
            stage,
            (from, to) -> {
              VertexSampler sampler = sampler(samples);
              VertexSampler other = sampler(dividedSamples);
              for (int vertex = from; vertex < to; vertex++) {
                VertexSampler own = isDivided(vertex) ? other : sampler;
                valid[vertex] = around(vertex, own, irradiance, false);
              }
              rays.add(sampler.rays() + other.rays());
            });
    if (!complete) {
      VertexSampler sampler = sampler(samples);
      for (int vertex = 0; vertex < facets.vertices(); vertex++) {
        valid[vertex] = around(vertex, sampler, irradiance, true);
      }
    }
    VertexHoleFilling.fill(facets, irradiance, valid);
    if (complete) {
      rays.add(rest(irradiance, valid));
    }
    return new VertexLight(irradiance, complete, rays.sum());
  }

  /**
   * Gathers at the vertices that are still without light: a part of a divided surface that is
   * covered everywhere has no neighbours to take light from and keeps the little light that it has;
   * a two-sided surface whose lit side is buried takes the light of its other side. Returns the
   * number of rays cast.
   */
  private long rest(float[] irradiance, boolean[] valid) {
    VertexSampler sampler = sampler(dividedSamples);
    sampler.countEverything();
    for (int vertex = 0; vertex < valid.length; vertex++) {
      if (!valid[vertex] && (isDivided(vertex) || hasTwoSides(vertex))) {
        valid[vertex] = around(vertex, sampler, irradiance, false);
      }
    }
    VertexHoleFilling.fill(facets, irradiance, valid);
    return sampler.rays();
  }

  private VertexSampler sampler(Samples with) {
    return new VertexSampler(scene, solution, sides, facets, divided, with);
  }

  private boolean isDivided(int vertex) {
    int first = corners.first()[vertex];
    return first < corners.corners().length && divided.get(corners.corners()[first] / 3);
  }

  /** Returns whether some facet around a vertex is two-sided. */
  private boolean hasTwoSides(int vertex) {
    for (int i = corners.first()[vertex]; i < corners.first()[vertex + 1]; i++) {
      int facet = corners.corners()[i] / 3;
      if (scene.triangles().twoSided()[facets.source()[facet]]) {
        return true;
      }
    }
    return false;
  }

  /**
   * Computes the area-weighted mean over the facets around a vertex; returns whether it is valid.
   */
  private boolean around(
      int vertex, VertexSampler sampler, float[] irradiance, boolean patchesOnly) {
    int first = corners.first()[vertex];
    int all = corners.first()[vertex + 1] - first;
    int used = Math.min(all, MOST_FACETS);
    int rays = sampler.most();
    if (sampler.small(corners.corners()[first], all)) {
      rays /= 2;
    }
    sampler.begin();
    for (int i = 0; i < used; i++) {
      int corner = corners.corners()[first + (int) ((long) i * all / used)];
      if (patchesOnly) {
        sampler.patches(corner);
      } else {
        sampler.sample(
            corner, i * rays / used, Math.max(i * rays / used + 1, (i + 1) * rays / used));
      }
    }
    return sampler.end(irradiance, 3 * vertex);
  }
}
