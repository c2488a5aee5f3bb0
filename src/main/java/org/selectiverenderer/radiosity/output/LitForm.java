package org.selectiverenderer.radiosity.output;

import java.nio.file.Path;
import java.util.Map;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.instance.ShapeInstance;

/** What becomes of lit shapes and of lights where a lit scene is written. */
public interface LitForm {
  /** The files that lit shapes are written to. */
  FilePlaces places();

  /**
   * The version of X3D that a file needs.
   *
   * @param place its number
   * @param version that it had
   */
  String version(int place, String version);

  /** Appends the shape of a body. */
  void shape(LitFile into, int body, ShapeInstance shape);

  /** Appends a light that has not been written yet. */
  void light(LitFile into, LightInstance light, String container);

  /** The pictures by file, once all shapes are written. */
  Map<Path, byte[]> pictures();
}
