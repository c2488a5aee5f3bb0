package org.selectiverenderer.scenes;

import java.util.Map;
import java.util.TreeMap;

/** The files in {@code inlineNodes/} that come from recipes: file name to text. */
final class InlineNodes {

  private static final String TRASH_CAN =
      "<Material diffuseColor='0.3 0.42 0.5' specularColor='0.35 0.35 0.35' shininess='0.35'/>";

  private InlineNodes() {}

  static Map<String, String> all() {
    Map<String, String> files = new TreeMap<>();
    files.put(
        "trashCan_v1.x3d",
        file(
            "TrashCan_v1",
            "Trash can, version 1: 1064 polygons, as modelled",
            TRASH_CAN,
            "creaseAngle='0.55'",
            TrashCan.v1()));
    files.put(
        "trashCan_v2.x3d",
        file(
            "TrashCan_v2",
            "Trash can, version 2: 93 polygons, the reduced one",
            TRASH_CAN,
            "creaseAngle='0.7'",
            TrashCan.v2()));
    files.put(
        "woodenFloor.x3d",
        X3dText.document("WoodenFloor", "Floor boards, 5.2 m by 5.5 m", WoodenFloor.shape()));
    files.put(
        "contactShadow.x3d",
        X3dText.document(
            "ContactShadow", "Soft shadow on a floor, radius 1", ContactShadow.shape()));
    return files;
  }

  private static String file(
      String def, String description, String material, String faceFields, TriangleMesh mesh) {
    String shape =
        """
            <Shape DEF='%s'>
              <Appearance>
                %s
              </Appearance>
              <IndexedFaceSet %s
                  coordIndex='%s'>
                <Coordinate point='%s'/>
              </IndexedFaceSet>
            </Shape>
        """
            .formatted(def, material, faceFields, mesh.coordIndexText(), mesh.pointText());
    return X3dText.document(def, description, shape);
  }
}
