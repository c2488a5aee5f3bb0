package org.selectiverenderer.apartment.scene;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.apartment.building.BlobShadow;
import org.selectiverenderer.apartment.facts.ExpectancyRatings;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.plan.FloorShadowCasters;
import org.selectiverenderer.apartment.plan.PlacedObject;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.apartment.textures.TextureRegistry;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.x3d.write.FieldValueFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes the text of the apartment's scene. */
public final class ApartmentSceneWriter {
  /** Height of a seated person's eye above the floor; participants sat (thesis Fig 83). */
  public static final double EYE = 1.2;

  /** Height of the lower end of an object, whose footprint determines its shadow, metres. */
  private static final double LOWER_END = 0.3;

  private final ObjectNodeWriter objects;

  public ApartmentSceneWriter(PolygonCounts counts, ExpectancyRatings expectancies) {
    this.objects = new ObjectNodeWriter(counts, expectancies);
  }

  /**
   * @param placed the objects of all rooms
   * @param fileName the scene's file name, for its title
   * @param enriched whether Switches and sensors have their metadata
   */
  public String text(List<PlacedObject> placed, String fileName, boolean enriched) {
    return text(
        placed,
        fileName,
        enriched,
        enriched ? "" : ", before its enrichment with metadata",
        Map.of());
  }

  /**
   * Returns the scene that radiosity lights: enriched, with photometric lights and without painted
   * shadows.
   *
   * @param shares polygons that each room's own surfaces are to have when lit
   */
  public String unlit(List<PlacedObject> placed, String fileName, Map<Room, Integer> shares) {
    return text(placed, fileName, true, ", before its light is computed by radiosity", shares);
  }

  private String text(
      List<PlacedObject> placed,
      String fileName,
      boolean enriched,
      String state,
      Map<Room, Integer> shares) {
    X3dWriter xml = new X3dWriter().file("Immersive", "3.3");
    head(xml, fileName, state);
    xml.open("Scene");
    xml.empty(
        "WorldInfo",
        "title",
        "Apartment",
        "info",
        FieldValueFormatter.strings(
            "Kitchen, lounge and office; objects are drawn by what one expects."));
    surroundings(xml);
    for (Room room : Room.values()) {
      if (shares.containsKey(room)) {
        unlitRoom(xml, room, placed, shares.get(room));
      } else {
        room(xml, room, placed, enriched);
      }
    }
    xml.comment("Thesis Figure 76, digit by digit.");
    AreaSensor.BOOKCASE.write(xml, enriched);
    AreaSensor.DESK.write(xml, enriched);
    AreaSensor.SOFA.write(xml, enriched);
    return xml.finish();
  }

  /** Writes how the viewer moves, where one may stand, and what is outside of the windows. */
  static void surroundings(X3dWriter xml) {
    xml.empty(
        "NavigationInfo",
        "type",
        "\"WALK\" \"ANY\"",
        "avatarSize",
        FieldValueText.numbers(0.25, EYE, 0.3),
        "speed",
        "1.2",
        "headlight",
        "false",
        "visibilityLimit",
        "60");
    viewpoints(xml);
    xml.empty(
        "Background",
        "skyColor",
        "0.3 0.5 0.78 0.55 0.72 0.9 0.86 0.92 0.96",
        "skyAngle",
        "1 1.57",
        "groundColor",
        "0.36 0.45 0.28 0.4 0.5 0.3 0.6 0.66 0.62",
        "groundAngle",
        "1.1 1.57",
        "frontUrl",
        outside(TextureRegistry.NORTH),
        "rightUrl",
        outside(TextureRegistry.EAST),
        "backUrl",
        outside(TextureRegistry.SOUTH),
        "leftUrl",
        outside(TextureRegistry.WEST));
  }

  private static void head(X3dWriter xml, String fileName, String state) {
    xml.open("head").meta("title", fileName);
    xml.meta("description", "The apartment of the thesis (chapter 5)" + state);
    xml.meta("generator", "./selective-renderer apartment").meta("license", "MIT").close();
  }

  private static String outside(String picture) {
    return FieldValueFormatter.strings("../inlineNodes/" + picture);
  }

  private static void viewpoints(X3dWriter xml) {
    viewpoint(xml, "KitchenView", "Kitchen", -1.8, 2.7, -46, -13);
    viewpoint(xml, "LoungeView", "Lounge", -5.2, -1, 152, -15);
    viewpoint(xml, "OfficeView", "Office", 4.7, 1.12, -77, -11);
    xml.empty(
        "Viewpoint",
        "DEF",
        "OverviewView",
        "description",
        "Overview",
        "position",
        "0 12.8 4.3",
        "orientation",
        FieldValueText.orientation(0, -72),
        "fieldOfView",
        "0.8");
    middle(xml, Room.KITCHEN, 0.1, -66, -10);
    middle(xml, Room.LOUNGE, 0, 140, -14);
    middle(xml, Room.OFFICE, 0, -110, -12);
  }

  /** Writes a viewpoint in the middle of a room, where participants turned round (thesis 6.1.1). */
  private static void middle(X3dWriter xml, Room room, double z, double yaw, double pitch) {
    String title = room.title();
    String name = "Middle of the " + title.toLowerCase(Locale.ROOT);
    viewpoint(xml, title + "Middle", name, room.middle(), z, yaw, pitch);
  }

  private static void viewpoint(
      X3dWriter xml, String def, String name, double x, double z, double yaw, double pitch) {
    xml.empty(
        "Viewpoint",
        "DEF",
        def,
        "description",
        name,
        "position",
        FieldValueText.numbers(x, Room.FLOOR + EYE, z),
        "orientation",
        FieldValueText.orientation(yaw, pitch),
        "fieldOfView",
        "1.05");
  }

  private void room(X3dWriter xml, Room room, List<PlacedObject> placed, boolean enriched) {
    xml.open("Group", "DEF", room.title());
    RoomLights.write(xml, room);
    xml.open("Transform", "translation", FieldValueText.numbers(0, Room.FLOOR, 0));
    String frame = room.name().toLowerCase(Locale.ROOT) + "Frame";
    xml.empty(
        "Inline",
        "DEF",
        "Inline_" + room.title() + "Frame_Definition",
        "url",
        FieldValueFormatter.strings("../inlineNodes/" + frame + ".x3d"));
    for (PlacedObject object : FloorShadowCasters.of(placed)) {
      if (object.placement().room() == room) {
        shadow(xml, object);
      }
    }
    objects(xml, room, placed, enriched);
    xml.close().close();
  }

  private void unlitRoom(X3dWriter xml, Room room, List<PlacedObject> placed, int share) {
    xml.open("Group", "DEF", room.title());
    xml.open("Transform", "translation", FieldValueText.numbers(0, Room.FLOOR, 0));
    PhotometricLights.write(xml, room);
    String file = room.title().toLowerCase(Locale.ROOT) + "Bare";
    xml.open(
        "Inline",
        "DEF",
        "Inline_" + room.title() + "Frame_Definition",
        "url",
        FieldValueFormatter.strings("../inlineNodes/" + file + ".x3d"));
    ObjectNodeWriter.set(xml, "metadata", room.title() + "FrameRadiosity", "radiosity");
    xml.empty(
        "MetadataInteger",
        "containerField",
        "value",
        "name",
        "polygons",
        "value",
        DecimalFormatter.rounded(share, 0));
    xml.close().close();
    objects(xml, room, placed, true);
    xml.close().close();
  }

  private void objects(X3dWriter xml, Room room, List<PlacedObject> placed, boolean enriched) {
    for (PlacedObject object : placed) {
      if (object.placement().room() == room) {
        objects.write(xml, object, enriched);
      }
    }
  }

  /**
   * Writes a shadow as large as the bounding box of the object's lower end, since a plant's leaves
   * cast none.
   */
  private static void shadow(X3dWriter xml, PlacedObject object) {
    BoundingBox box = object.lowerBox(LOWER_END);
    double x = (box.minX() + box.maxX()) / 2;
    double z = (box.minZ() + box.maxZ()) / 2;
    xml.open(
        "Transform",
        "translation",
        FieldValueText.numbers(object.x(), object.y() + box.minY() + BlobShadow.LIFT, object.z()),
        "rotation",
        FieldValueText.yaw(object.yaw()));
    xml.open(
        "Transform",
        "translation",
        FieldValueText.numbers(x, 0, z),
        "scale",
        FieldValueText.numbers(box.width() / 2, 1, box.depth() / 2));
    xml.empty("Inline", "url", FieldValueFormatter.strings("../inlineNodes/" + BlobShadow.FILE));
    xml.close().close();
  }
}
