package org.selectiverenderer.scenes;

import java.util.Locale;

/** The frame that every generated object file has. */
final class X3dText {

  private X3dText() {}

  /**
   * @param name the object's name; the file is called so, with a small first letter
   * @param scene the content of the Scene element, indented by four
   */
  static String document(String name, String description, String scene) {
    return """
    <?xml version="1.0" encoding="UTF-8"?>
    <X3D profile='Interchange' version='3.3'>
      <head>
        <meta name='title' content='%s.x3d'/>
        <meta name='description' content='%s'/>
        <meta name='generator' content='src/test/java/org/selectiverenderer/scenes'/>
        <meta name='license' content='MIT'/>
      </head>
      <Scene>
    %s  </Scene>
    </X3D>
    """
        .formatted(
            name.substring(0, 1).toLowerCase(Locale.ROOT) + name.substring(1), description, scene);
  }
}
