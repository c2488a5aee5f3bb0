package org.selectiverenderer.radiosity.output;

import java.util.Arrays;
import java.util.BitSet;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.radiosity.bake.GlossySurfaceFinder;
import org.selectiverenderer.radiosity.bake.TextureBakePlan;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * The glossy bodies whose colours are all in one lightmap, and the X3D Materials that add specular
 * highlights to it.
 */
final class SpecularMaterials {
  private static final int DECIMALS = 3;

  private final BitSet bodies;

  private SpecularMaterials(BitSet bodies) {
    this.bodies = bodies;
  }

  /** Returns the set without glossy bodies. */
  static SpecularMaterials none() {
    return new SpecularMaterials(new BitSet());
  }

  /**
   * Returns the glossy bodies of a scene; a body whose own texture stays cannot be one: see {@link
   * GlossySurfaceFinder}.
   */
  static SpecularMaterials of(RadiosityScene scene, TextureBakePlan use) {
    BitSet bodies = new BitSet();
    for (int i = 0; i < scene.bodies().size(); i++) {
      bodies.set(
          i, !use.apart(i) && GlossySurfaceFinder.shines(scene.bodies().get(i).shape().surface()));
    }
    return new SpecularMaterials(bodies);
  }

  boolean on(int body) {
    return bodies.get(body);
  }

  int count() {
    return bodies.cardinality();
  }

  /** Opens the Material of a glossy body. */
  static void open(X3dWriter out, Body body) {
    SurfaceMaterial surface = body.shape().surface();
    float[] s = surface.specular();
    out.open(
        "Material",
        "diffuseColor",
        "0 0 0",
        "ambientIntensity",
        "0",
        "emissiveColor",
        "1 1 1",
        "specularColor",
        text(s[0]) + " " + text(s[1]) + " " + text(s[2]),
        "shininess",
        text(surface.shininess()));
    if (surface.transparency() > 0) {
      out.attribute("transparency", text(surface.transparency()));
    }
  }

  /** Returns a key that differs for different Materials. */
  static String fields(Body body) {
    SurfaceMaterial surface = body.shape().surface();
    return Arrays.toString(surface.specular()) + surface.shininess();
  }

  static String text(float value) {
    return DecimalFormatter.rounded(value, DECIMALS);
  }
}
