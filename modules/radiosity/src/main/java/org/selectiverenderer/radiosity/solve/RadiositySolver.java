package org.selectiverenderer.radiosity.solve;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.radiosity.parallel.ParallelFor;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/**
 * Solves the radiosity equation B = E + rho F B (Goral et al. 1984; thesis 2.1.4) by gathering: in
 * iteration k every patch gathers the light that the patches visible from it had after iteration k
 * - 1, so light has been reflected k times (Jacobi's method; Kajiya's Neumann series, 1986). Light
 * only grows from one iteration to the next. Since the form factors are found beforehand, an
 * iteration costs no rays, and the solver can stop after any of them as in progressive refinement
 * (Cohen et al. 1988). When the requested share of the energy is distributed, the rest is estimated
 * and added, as Cohen et al. do by an ambient term.
 */
public final class RadiositySolver {
  private final RadiosityScene scene;
  private final MonteCarloFormFactors transport;
  private final SurfacePatches patches;
  private final float[] rho;
  private final float[] glow;
  private final double[] outsideShare;
  private final int[] inside;

  public RadiositySolver(RadiosityScene scene, MonteCarloFormFactors transport) {
    this.scene = scene;
    this.transport = transport;
    patches = transport.patches();
    int count = patches.count();
    rho = new float[3 * count];
    glow = new float[3 * count];
    outsideShare = new double[count];
    inside = new int[count];
    for (int patch = 0; patch < count; patch++) {
      Body body = scene.body(patches.triangle(patch));
      int at = body.reflectanceAt(patches.triangle(patch) - body.firstTriangle());
      boolean sampled = scene.sampled()[scene.bodyOf()[patches.triangle(patch)]];
      // A body's reflectance and emission are per whole surface, but rays are stopped by its opaque
      // share only.
      float opaque = 1 - body.transmittance();
      for (int c = 0; c < 3 && opaque > 0; c++) {
        rho[3 * patch + c] = body.reflectance()[at + c] / opaque;
        glow[3 * patch + c] = sampled ? 0 : body.emission()[c] / opaque;
      }
      int outside = 0;
      for (int i = 0; i < transport.rays(patch); i++) {
        int met = transport.seen(patch, i);
        outside += met == MonteCarloFormFactors.OUTSIDE ? 1 : 0;
        inside[patch] += met == MonteCarloFormFactors.INSIDE ? 1 : 0;
      }
      int valid = transport.rays(patch) - inside[patch];
      outsideShare[patch] = valid == 0 ? 0 : (double) outside / valid;
    }
  }

  /**
   * Iterates. If the work is cancelled, the last complete iteration is returned; if none is
   * complete, the solution has no balances.
   *
   * @param iterations largest number of iterations
   * @param quality percent of the energy distributed at which the solver stops
   * @param each receives the solution after every iteration; it must not keep it
   */
  public RadiositySolution solve(
      int iterations,
      double quality,
      RadiosityProgress progress,
      Consumer<RadiositySolution> each) {
    int count = patches.count();
    boolean[] buried = new boolean[count];
    for (int patch = 0; patch < count; patch++) {
      buried[patch] = inside[patch] > MonteCarloFormFactors.BURIED * transport.rays(patch);
    }
    float[] before = new float[3 * count];
    SeriesRemainder rest = new SeriesRemainder();
    float[] indirect = new float[3 * count];
    List<EnergyBalance> balances = new ArrayList<>();
    RadiositySolution solution =
        new RadiositySolution(
            patches,
            before,
            glow,
            transport.direct(),
            indirect,
            transport.lampsOf(),
            buried,
            balances);
    for (int k = 1; k <= iterations; k++) {
      float[] source = before;
      float[] arriving = new float[3 * count];
      float[] after = new float[3 * count];
      boolean whole =
          ParallelFor.run(
              count,
              4096,
              progress,
              RadiosityProgress.Stage.ITERATIONS,
              (from, to) -> {
                for (int patch = from; patch < to; patch++) {
                  if (!buried[patch]) {
                    gather(patch, source, arriving, after);
                  }
                }
              });
      if (!whole) {
        break; // The last complete iteration stays.
      }
      balances.add(balance(k, source, arriving, after, buried, balances));
      before = after;
      solution =
          new RadiositySolution(
              patches,
              after,
              glow,
              transport.direct(),
              arriving,
              transport.lampsOf(),
              buried,
              List.copyOf(balances));
      each.accept(solution);
      rest.heard(arriving);
      if (solution.last().distributed() >= quality) {
        return whole(solution, rest);
      }
    }
    return solution;
  }

  /** Returns the solution with the estimated remainder of the series added. */
  private RadiositySolution whole(RadiositySolution solution, SeriesRemainder rest) {
    float[] indirect = rest.added(solution.balances());
    float[] reflected = solution.reflected().clone();
    for (int i = 0; i < reflected.length; i++) {
      reflected[i] += (float) (rho[i] * (indirect[i] - solution.indirect()[i]) / Math.PI);
    }
    return new RadiositySolution(
        patches,
        reflected,
        glow,
        solution.direct(),
        indirect,
        solution.lampsOf(),
        solution.buried(),
        solution.balances());
  }

  private void gather(int patch, float[] source, float[] arriving, float[] after) {
    double r = 0;
    double g = 0;
    double b = 0;
    int rays = transport.rays(patch);
    for (int i = 0; i < rays; i++) {
      int other = transport.seen(patch, i);
      if (other >= 0) {
        int at = 3 * other;
        r += source[at] + glow[at];
        g += source[at + 1] + glow[at + 1];
        b += source[at + 2] + glow[at + 2];
      }
    }
    double scale = Math.PI / (rays - inside[patch]);
    int at = 3 * patch;
    arriving[at] = (float) (r * scale);
    arriving[at + 1] = (float) (g * scale);
    arriving[at + 2] = (float) (b * scale);
    for (int c = 0; c < 3; c++) {
      double irradiance = transport.direct()[at + c] / open(patch) + arriving[at + c];
      after[at + c] = (float) (rho[at + c] * irradiance / Math.PI);
    }
  }

  private EnergyBalance balance(
      int k,
      float[] source,
      float[] arriving,
      float[] after,
      boolean[] buried,
      List<EnergyBalance> earlier) {
    double emitted = 0;
    double absorbed = 0;
    double escaped = 0;
    double unshot = 0;
    double reflected = 0;
    for (int patch = 0; patch < patches.count(); patch++) {
      // Versions other than the reference receive light but give none to others.
      if (buried[patch] || !scene.stands(patches.triangle(patch))) {
        continue;
      }
      // Light arrived at the open share of the patch only: see open().
      double area = patches.area(patch) * open(patch);
      // Light that passes through glass is counted where it arrives.
      double through = scene.body(patches.triangle(patch)).transmittance();
      for (int c = 0; c < 3; c++) {
        int at = 3 * patch + c;
        double weight = c == 0 ? 0.2126 : c == 1 ? 0.7152 : 0.0722;
        double flux = weight * area * (1 - through);
        double direct = transport.direct()[at] / open(patch);
        double irradiance = direct + arriving[at];
        emitted += flux * (direct + Math.PI * glow[at]);
        absorbed += flux * Math.max(0, 1 - rho[at]) * irradiance;
        escaped += flux * Math.PI * (source[at] + glow[at]) * outsideShare[patch];
        unshot += flux * Math.PI * (after[at] - source[at]);
        reflected += flux * Math.PI * after[at];
      }
    }
    return new EnergyBalance(
        k, emitted, absorbed, escaped, unshot, distributed(unshot, reflected, emitted, earlier));
  }

  /**
   * Returns the share of a patch that lies outside of solids. Direct light was averaged over the
   * whole patch, of which the rest receives none; a patch that is not buried is open by an eighth
   * at least.
   */
  private double open(int patch) {
    return 1 - (double) inside[patch] / transport.rays(patch);
  }

  /**
   * Estimates the percentage of the energy that is distributed; the rest is extrapolated as a
   * geometric series of the last two iterations.
   */
  private static double distributed(
      double unshot, double reflected, double emitted, List<EnergyBalance> earlier) {
    double before = earlier.isEmpty() ? emitted : earlier.get(earlier.size() - 1).unshot();
    if (!(unshot > 0)) {
      return 100;
    }
    double ratio = before > 0 ? Math.min(0.999, unshot / before) : 0;
    double rest = unshot * ratio / (1 - ratio);
    return 100 * (emitted + reflected) / (emitted + reflected + rest);
  }

  /**
   * Estimates the remainder of the Neumann series, the light that later iterations would add: its
   * terms soon shrink by a constant factor, the mean reflectance of the scene, so the remainder is
   * that of a geometric series. The factor is that of the whole scene, since where little light
   * arrives early, as under a table, a patch's own terms do not shrink yet.
   */
  private static final class SeriesRemainder {
    /** Largest factor: see {@code scene.Reflectance}. */
    private static final double MOST = 0.95;

    private float @Nullable [] last;
    private float @Nullable [] before;

    /**
     * @param irradiance r, g, b of each patch after an iteration; it must not be changed later
     */
    void heard(float[] irradiance) {
      before = last;
      last = irradiance;
    }

    /**
     * Returns the last irradiance plus the estimated remainder; after the first iteration the
     * irradiance as it is.
     *
     * @param balances the energy balances of all iterations
     */
    float[] added(List<EnergyBalance> balances) {
      if (last == null) {
        throw new IllegalStateException("no iteration has been added");
      }
      float[] sum = last.clone();
      int count = balances.size();
      if (before == null || count < 2 || !(balances.get(count - 2).unshot() > 0)) {
        return sum;
      }
      double shrinks = balances.get(count - 1).unshot() / balances.get(count - 2).unshot();
      double factor = Math.max(0, Math.min(MOST, shrinks));
      for (int i = 0; i < sum.length; i++) {
        sum[i] += (float) (Math.max(0, last[i] - before[i]) * factor / (1 - factor));
      }
      return sum;
    }
  }
}
