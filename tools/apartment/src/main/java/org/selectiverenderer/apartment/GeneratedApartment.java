package org.selectiverenderer.apartment;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.selectiverenderer.apartment.building.BlobShadow;
import org.selectiverenderer.apartment.building.RoomModels;
import org.selectiverenderer.apartment.facts.ExpectancyRatings;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.plan.FloorShadowCasters;
import org.selectiverenderer.apartment.plan.FurniturePlan;
import org.selectiverenderer.apartment.plan.PlacedObject;
import org.selectiverenderer.apartment.plan.PlacementResolver;
import org.selectiverenderer.apartment.plan.PlannedObject;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.apartment.scene.ApartmentSceneWriter;
import org.selectiverenderer.apartment.scene.ApartmentTour;
import org.selectiverenderer.apartment.scene.PracticeScene;
import org.selectiverenderer.apartment.textures.TextureImage;
import org.selectiverenderer.apartment.textures.TextureRegistry;
import org.selectiverenderer.apartment.versions.GeneratedFile;
import org.selectiverenderer.apartment.versions.GeneratedObject;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExactCountRefiner;
import org.selectiverenderer.modelling.GridSnapping;
import org.selectiverenderer.modelling.ParametricModel;

/**
 * The generated files of the whole apartment, in memory.
 *
 * @param placed the objects at their positions, as version 1
 * @param models the files of the objects and of the rooms
 * @param texts the scenes, the models and the recorded walk: path below the project's folder to
 *     text
 * @param pictures the textures: path below the project's folder to image
 */
record GeneratedApartment(
    List<PlacedObject> placed,
    List<GeneratedFile> models,
    Map<String, String> texts,
    Map<String, TextureImage> pictures) {

  static GeneratedApartment make(ObjectFileGenerator files, PolygonCounts counts) {
    List<PlannedObject> placements = FurniturePlan.all();
    List<GeneratedObject> objects =
        files.of(placements.stream().map(PlannedObject::object).distinct().toList());
    Map<String, ParametricModel> originals = new HashMap<>();
    objects.forEach(object -> originals.put(object.model().name(), object.model()));
    Map<Room, TriangleMesh> floors = new EnumMap<>(Room.class);
    for (Room room : Room.values()) {
      floors.put(room, RoomModels.of(room).mesh());
    }
    List<PlacedObject> placed = PlacementResolver.of(placements, originals::get, floors::get);

    List<GeneratedFile> inlineNodes = new ArrayList<>();
    objects.forEach(object -> inlineNodes.addAll(object.files()));
    Map<Room, Integer> shares = new EnumMap<>(Room.class);
    single(List.of(), placed, counts)
        .forEach(
            (room, polygons) -> {
              shares.put(room, room.fixedPolygons() - polygons);
              inlineNodes.addAll(files.single(bare(room)).files());
            });
    single(FloorShadowCasters.of(placed), placed, counts)
        .forEach(
            (room, polygons) -> inlineNodes.addAll(files.single(frame(room, polygons)).files()));
    ApartmentSceneWriter scene = new ApartmentSceneWriter(counts, ExpectancyRatings.load());
    Map<String, String> texts = new TreeMap<>();
    inlineNodes.forEach(file -> texts.put("inlineNodes/" + file.name(), file.text()));
    texts.put("inlineNodes/" + BlobShadow.FILE, BlobShadow.text());
    texts.put("scenes/apartment.x3d", scene.text(placed, "apartment.x3d", true));
    texts.put("scenes/apartment-plain.x3d", scene.text(placed, "apartment-plain.x3d", false));
    texts.put("scenes/apartment-unlit.x3d", scene.unlit(placed, "apartment-unlit.x3d", shares));
    texts.put("scenes/practice.x3d", PracticeScene.text());
    texts.put("scenes/paths/apartment-tour.csv", ApartmentTour.text());
    Map<String, TextureImage> pictures = new TreeMap<>();
    TextureRegistry.all().forEach((name, made) -> pictures.put("inlineNodes/" + name, made.get()));
    return new GeneratedApartment(placed, inlineNodes, texts, pictures);
  }

  /** Returns a room's frame refined so that the room's polygons add up to the thesis's total. */
  private static ParametricModel frame(Room room, int polygonsOfOthers) {
    return ExactCountRefiner.refine(
        GridSnapping.toGrid(RoomModels.of(room)), room.fixedPolygons() - polygonsOfOthers);
  }

  /**
   * Returns a room's frame with no more polygons than it needs; radiosity adds the others where
   * light changes.
   */
  private static ParametricModel bare(Room room) {
    return GridSnapping.toGrid(RoomModels.bare(room))
        .named(room.title().toLowerCase(Locale.ROOT) + "Bare");
  }

  /** Counts the polygons of the objects with one version and of the shadows, by room. */
  private static Map<Room, Integer> single(
      List<PlacedObject> shadows, List<PlacedObject> placed, PolygonCounts counts) {
    Map<Room, Integer> polygons = new EnumMap<>(Room.class);
    for (Room room : Room.values()) {
      polygons.put(room, 0);
    }
    for (PlacedObject object : shadows) {
      polygons.merge(object.placement().room(), BlobShadow.polygons(), Integer::sum);
    }
    for (PlacedObject object : placed) {
      if (counts.of(object.object()).isEmpty()) {
        polygons.merge(object.placement().room(), object.model().polygons(), Integer::sum);
      }
    }
    return polygons;
  }
}
