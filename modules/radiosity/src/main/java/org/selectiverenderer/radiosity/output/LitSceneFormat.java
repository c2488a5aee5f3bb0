package org.selectiverenderer.radiosity.output;

import java.nio.file.Path;
import java.util.Map;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.browser.instance.ShapeInstance;

/** The format in which a lit scene stores its light: how lit shapes and lights are written. */
public interface LitSceneFormat {
  /** Returns the numbers of the files that lit shapes are written to. */
  OutputFileIndex places();

  /**
   * Returns the version of X3D that a file needs.
   *
   * @param place number of the file
   * @param version the version of the original file
   */
  String version(int place, String version);

  /** Appends the shape of a body. */
  void shape(LitFileWriter into, int body, ShapeInstance shape);

  /** Appends a light that has not been written yet. */
  void light(LitFileWriter into, LightInstance light, String container);

  /** Returns the images by file, once all shapes are written. */
  Map<Path, byte[]> pictures();
}
