package org.selectiverenderer.radiosity.texel;

import java.util.stream.IntStream;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;

/** Looks up the light of the patches at texels, without casting rays. */
final class PatchLightLookup {
  private static final int CHUNK = 64;

  private final RadiosityScene scene;
  private final RadiositySolution solution;
  private final TexelIndex texels;

  PatchLightLookup(RadiosityScene scene, RadiositySolution solution, TexelIndex texels) {
    this.scene = scene;
    this.solution = solution;
    this.texels = texels;
  }

  /** Returns the direct and indirect irradiance of the patches at all texels. */
  float[] all() {
    float[] light = new float[3 * texels.count()];
    add(light, solution.direct());
    add(light, solution.indirect());
    return light;
  }

  /** Adds the indirect irradiance of the patches. */
  void addIndirect(float[] light) {
    add(light, solution.indirect());
  }

  private void add(float[] light, float[] ofPatches) {
    IntStream.range(0, (texels.tiles() + CHUNK - 1) / CHUNK)
        .parallel()
        .forEach(
            chunk -> {
              TexelSurfacePoint place = new TexelSurfacePoint(scene, solution, texels);
              int end = Math.min(texels.tiles(), (chunk + 1) * CHUNK);
              for (int tile = chunk * CHUNK; tile < end; tile++) {
                texels.each(
                    tile,
                    texel -> {
                      place.at(texel);
                      for (int c = 0; c < 3; c++) {
                        light[3 * texel + c] += ofPatches[3 * place.patch + c];
                      }
                    });
              }
            });
  }
}
