package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.textures.TextureRegistry;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.TextureMapping;

/** Wood materials with a texture of their grain. */
final class WoodMaterials {
  /** The veneer of the rooms' doors, with the grain upright. */
  static final ModelMaterial VENEER =
      ModelMaterial.satin(ModelColour.grey(1))
          .clad(
              TextureMapping.metric(
                  TextureRegistry.VENEER,
                  TextureRegistry.VENEER_WIDTH,
                  TextureRegistry.VENEER_HEIGHT));

  private WoodMaterials() {}
}
