package org.selectiverenderer.apartment;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.selectiverenderer.apartment.facts.Expectancies;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.frame.Frames;
import org.selectiverenderer.apartment.frame.SoftShadow;
import org.selectiverenderer.apartment.plan.Layout;
import org.selectiverenderer.apartment.plan.Placed;
import org.selectiverenderer.apartment.plan.Placement;
import org.selectiverenderer.apartment.plan.Placements;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.apartment.plan.Shadows;
import org.selectiverenderer.apartment.scene.ApartmentScene;
import org.selectiverenderer.apartment.scene.PracticeScene;
import org.selectiverenderer.apartment.scene.Tour;
import org.selectiverenderer.apartment.versions.MadeObject;
import org.selectiverenderer.apartment.versions.ObjectFile;
import org.selectiverenderer.modelling.ExactCount;
import org.selectiverenderer.modelling.Model;
import org.selectiverenderer.modelling.Rounding;
import org.selectiverenderer.modelling.TriangleMesh;

/**
 * All of the apartment in memory.
 *
 * @param placed the objects where they stand, as version 1
 * @param models the files of the objects and of the rooms
 * @param texts all files: path below the project's folder to text
 */
record Apartment(List<Placed> placed, List<ObjectFile> models, Map<String, String> texts) {

  static Apartment make(ObjectFiles files, PolygonCounts counts) {
    List<Placement> placements = Placements.all();
    List<MadeObject> objects =
        files.of(placements.stream().map(Placement::object).distinct().toList());
    Map<String, Model> originals = new HashMap<>();
    objects.forEach(object -> originals.put(object.model().name(), object.model()));
    Map<Room, TriangleMesh> floors = new EnumMap<>(Room.class);
    for (Room room : Room.values()) {
      floors.put(room, Frames.of(room).mesh());
    }
    List<Placed> placed = Layout.of(placements, originals::get, floors::get);

    List<ObjectFile> inlineNodes = new ArrayList<>();
    objects.forEach(object -> inlineNodes.addAll(object.files()));
    Map<Room, Integer> shares = new EnumMap<>(Room.class);
    single(List.of(), placed, counts)
        .forEach(
            (room, polygons) -> {
              shares.put(room, room.fixedPolygons() - polygons);
              inlineNodes.addAll(files.single(bare(room)).files());
            });
    single(Shadows.of(placed), placed, counts)
        .forEach(
            (room, polygons) -> inlineNodes.addAll(files.single(frame(room, polygons)).files()));
    ApartmentScene scene = new ApartmentScene(counts, Expectancies.load());
    Map<String, String> texts = new TreeMap<>();
    inlineNodes.forEach(file -> texts.put("inlineNodes/" + file.name(), file.text()));
    texts.put("inlineNodes/" + SoftShadow.FILE, SoftShadow.text());
    texts.put("scenes/apartment.x3d", scene.text(placed, "apartment.x3d", true));
    texts.put("scenes/apartment-plain.x3d", scene.text(placed, "apartment-plain.x3d", false));
    texts.put("scenes/apartment-unlit.x3d", scene.unlit(placed, "apartment-unlit.x3d", shares));
    texts.put("scenes/practice.x3d", PracticeScene.text());
    texts.put("scenes/paths/apartment-tour.csv", Tour.text());
    return new Apartment(placed, inlineNodes, texts);
  }

  /** What the room's frame has to be brought to, so that the thesis's totals come out. */
  private static Model frame(Room room, int polygonsOfOthers) {
    return ExactCount.refine(
        Rounding.toGrid(Frames.of(room)), room.fixedPolygons() - polygonsOfOthers);
  }

  /**
   * A room's frame with no more polygons than it needs: radiosity puts the others where light is.
   */
  private static Model bare(Room room) {
    return Rounding.toGrid(Frames.bare(room)).named(room.title().toLowerCase(Locale.ROOT) + "Bare");
  }

  /** Polygons of the objects with one version and of the shadows, by room. */
  private static Map<Room, Integer> single(
      List<Placed> shadows, List<Placed> placed, PolygonCounts counts) {
    Map<Room, Integer> polygons = new EnumMap<>(Room.class);
    for (Room room : Room.values()) {
      polygons.put(room, 0);
    }
    for (Placed object : shadows) {
      polygons.merge(object.placement().room(), SoftShadow.polygons(), Integer::sum);
    }
    for (Placed object : placed) {
      if (counts.of(object.object()).isEmpty()) {
        polygons.merge(object.placement().room(), object.model().polygons(), Integer::sum);
      }
    }
    return polygons;
  }
}
