package org.selectiverenderer.models.gltf;

import java.io.IOException;

/** Tells that a model is glTF 1.0, which has other members than 2.0. */
final class OldGltfException extends IOException {
  private static final long serialVersionUID = 1;

  OldGltfException() {
    super("this is a model in glTF 1.0; convert it to 2.0, for example with gltf-pipeline");
  }
}
