package org.selectiverenderer.apartment;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.apartment.building.BlobShadow;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.facts.PolygonCounts.Counts;
import org.selectiverenderer.apartment.plan.FloorShadowCasters;
import org.selectiverenderer.apartment.plan.Footprint;
import org.selectiverenderer.apartment.plan.PlacedObject;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.apartment.plan.RoomPosition;
import org.selectiverenderer.apartment.textures.TextureImage;
import org.selectiverenderer.apartment.versions.GeneratedFile;

/** The apartment that the recipes make now, and the files of it that are kept. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class GeneratedApartmentTest {
  private final PolygonCounts counts = PolygonCounts.load();
  private final Map<String, Integer> polygons = new HashMap<>();
  private final Map<String, byte[]> pictures = new TreeMap<>();
  private GeneratedApartment apartment;

  @BeforeAll
  void make() {
    apartment =
        GeneratedApartment.make(
            new ObjectFileGenerator(ApartmentGenerator.RecipeRegistry.all(), counts), counts);
    apartment.models().forEach(file -> polygons.put(file.name(), file.polygons()));
    polygons.put(BlobShadow.FILE, BlobShadow.polygons());
    apartment.pictures().forEach((file, picture) -> pictures.put(file, picture.png()));
  }

  /** After a change of a recipe or of the plan: {@code ./selective-renderer apartment --force}. */
  @Test
  void theFilesThatAreKeptAreWhatTheGeneratorMakes() throws Exception {
    for (Map.Entry<String, String> file : apartment.texts().entrySet()) {
      Path path = Path.of(file.getKey());
      assertThat(path).isRegularFile();
      // Not isEqualTo, whose message would be megabytes.
      assertThat(Files.readString(path, StandardCharsets.UTF_8).equals(file.getValue()))
          .as("%s is up to date", path)
          .isTrue();
    }
  }

  /** Pixels, since how far a file is compressed is up to the Java that writes it. */
  @Test
  void thePicturesThatAreKeptAreWhatTheGeneratorMakes() throws Exception {
    for (Map.Entry<String, byte[]> made : pictures.entrySet()) {
      byte[] kept = Files.readAllBytes(Path.of(made.getKey()));
      // The same bytes are the same pixels, which take longer to compare.
      if (!Arrays.equals(kept, made.getValue())) {
        BufferedImage then = ImageIO.read(new ByteArrayInputStream(kept));
        BufferedImage now = ImageIO.read(new ByteArrayInputStream(made.getValue()));
        assertThat(then.getWidth()).isEqualTo(now.getWidth());
        assertThat(pixels(then)).as("%s is up to date", made.getKey()).isEqualTo(pixels(now));
      }
    }
  }

  private static int[] pixels(BufferedImage image) {
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  @Test
  void everyPictureIsShownAndEveryPictureThatIsNamedIsThere() {
    Set<String> named = new HashSet<>();
    Pattern matcher = Pattern.compile("\"(?:\\.\\./inlineNodes/)?(textures/[^\"]+)\"");
    for (String text : apartment.texts().values()) {
      matcher.matcher(text).results().forEach(found -> named.add("inlineNodes/" + found.group(1)));
    }
    assertThat(named).isEqualTo(apartment.pictures().keySet());
  }

  @Test
  void picturesAreNoLargerThanOneSees() {
    int bytes = 0;
    for (TextureImage picture : apartment.pictures().values()) {
      assertThat(picture.width()).isLessThanOrEqualTo(512);
      assertThat(picture.height()).isLessThanOrEqualTo(1024);
    }
    for (byte[] file : pictures.values()) {
      bytes += file.length;
    }
    assertThat(bytes).isLessThan(2_000_000);
  }

  @Test
  void everyListedObjectHasTheTablesPolygonsInBothVersions() {
    for (Counts count : counts.all().values()) {
      assertThat(polygons.get(count.object() + "_v1.x3d"))
          .as(count.object())
          .isEqualTo(count.original());
      assertThat(polygons.get(count.object() + "_v2.x3d"))
          .as(count.object())
          .isEqualTo(count.reduced());
    }
  }

  @Test
  void everyListedObjectStandsInItsRoom() {
    Map<String, Room> rooms = new HashMap<>();
    apartment.placed().forEach(p -> rooms.put(p.object(), p.placement().room()));
    for (Counts count : counts.all().values()) {
      assertThat(rooms.get(count.object()))
          .as(count.object())
          .hasToString(count.area().toUpperCase(java.util.Locale.ROOT));
    }
  }

  /** Thesis Tables 3 to 5: version 1 everywhere, and version 2 everywhere. */
  @ParameterizedTest
  @CsvSource({"KITCHEN, 277224, 49135", "LOUNGE, 215558, 27729", "OFFICE, 291489, 67003"})
  void theRoomsHaveTheTotalsOfTheThesis(Room room, int allHigh, int roomSchema) {
    assertThat(total(room, "_v1.x3d")).isEqualTo(allHigh);
    assertThat(total(room, "_v2.x3d")).isEqualTo(roomSchema);
  }

  private int total(Room room, String version) {
    int sum = polygons.get(room.title().toLowerCase(java.util.Locale.ROOT) + "Frame.x3d");
    for (PlacedObject placed : apartment.placed()) {
      if (placed.placement().room() == room) {
        boolean listed = counts.of(placed.object()).isPresent();
        sum += polygons.get(placed.object() + (listed ? version : ".x3d"));
      }
    }
    for (PlacedObject placed : FloorShadowCasters.of(apartment.placed())) {
      sum += placed.placement().room() == room ? BlobShadow.polygons() : 0;
    }
    return sum;
  }

  /** In the files' own digits, so that rounding has been done. */
  @Test
  void noTriangleOfAFileIsALine() {
    List<String> lines = new ArrayList<>();
    for (GeneratedFile file : apartment.models()) {
      int flat = IndependentX3dReader.linesAmongTriangles(file.text());
      if (flat > 0) {
        lines.add(file.name() + ": " + flat);
      }
    }
    assertThat(lines).isEmpty();
  }

  @ParameterizedTest
  @EnumSource(Room.class)
  void objectsKeepWithinTheirRoom(Room room) {
    for (PlacedObject placed : apartment.placed()) {
      if (placed.placement().room() == room) {
        Footprint box = new Footprint(placed);
        String name = placed.object();
        assertThat(box.reach(true)[0]).as(name).isGreaterThan(room.west() - 0.001);
        assertThat(box.reach(true)[1]).as(name).isLessThan(room.east() + 0.001);
        assertThat(box.reach(false)[0]).as(name).isGreaterThan(Room.NORTH - 0.001);
        assertThat(box.reach(false)[1]).as(name).isLessThan(Room.SOUTH + 0.001);
        assertThat(box.top()).as(name).isLessThan(Room.HEIGHT);
        assertThat(box.bottom()).as(name).isGreaterThan(-0.001);
      }
    }
  }

  @Test
  void objectsDoNotReachIntoEachOtherUnlessOneHoldsTheOther() {
    List<String> overlaps = new ArrayList<>();
    List<PlacedObject> all = apartment.placed();
    for (int i = 0; i < all.size(); i++) {
      for (int j = 0; j < i; j++) {
        PlacedObject a = all.get(i);
        PlacedObject b = all.get(j);
        double overlap = holds(a, b) || holds(b, a) ? 0 : overlap(a, b);
        if (overlap > 0.002) {
          overlaps.add(
              "%s and %s by %.3f m".formatted(a.placement().name(), b.placement().name(), overlap));
        }
      }
    }
    assertThat(overlaps).isEmpty();
  }

  /** Boxes around pieces, so that a chair can be pushed under a table. */
  private static double overlap(PlacedObject a, PlacedObject b) {
    double most = new Footprint(a).overlap(new Footprint(b));
    if (most <= 0.002) {
      return most;
    }
    most = 0;
    List<Footprint> others = piecesIn(b, a);
    for (Footprint piece : piecesIn(a, b)) {
      for (Footprint other : others) {
        most = Math.max(most, piece.overlap(other));
      }
    }
    return most;
  }

  private static List<Footprint> piecesIn(PlacedObject object, PlacedObject box) {
    Footprint whole = new Footprint(box);
    return Footprint.pieces(object).stream().filter(p -> p.overlap(whole) > 0.002).toList();
  }

  private static boolean holds(PlacedObject holder, PlacedObject held) {
    return held.placement().place() instanceof RoomPosition.On on
        && on.support().equals(holder.placement().name());
  }

  /** Layout lets things down until they touch; here the triangles are asked once more. */
  @Test
  void whatStandsOnAnotherTouchesItAndIsNotSunkIn() {
    Map<String, PlacedObject> byName = new HashMap<>();
    apartment.placed().forEach(p -> byName.put(p.placement().name(), p));
    for (PlacedObject placed : apartment.placed()) {
      if (placed.placement().place() instanceof RoomPosition.On on) {
        PlacedObject support = byName.get(on.support());
        double gap = ContactMeasurement.gap(placed.mesh(), support.mesh());
        assertThat(gap).as("%s on %s", placed.object(), on.support()).isBetween(-0.002, 0.002);
      }
    }
  }

  @Test
  void sensorsStandWhereTheThesisHasThem() {
    String scene = text("scenes/apartment.x3d");
    assertThat(scene)
        .contains("DEF='boxLibrary' scale='1.078 2.368 1.338' translation='3.744 -1.93 -1.107'")
        .contains("<Transform translation='0.0 0.8219 0.0'>")
        .contains("<ProximitySensor DEF='BookcaseProx' size='2.643 1.644 3.159'>")
        .contains("DEF='boxDesk' scale='1.809 2.182 1.0' translation='5.779 -1.946 0.7717'")
        .contains("<Transform translation='0.0 0.8541 0.0'>")
        .contains("<ProximitySensor DEF='DeskProx' size='3.255 1.708 3.449'>")
        .contains("DEF='boxLounge' scale='1.14 1.058 1.136' translation='-5.461 -1.963 0.4947'")
        .contains("<Transform translation='0.0 1.76 0.0'>")
        .contains("<ProximitySensor DEF='SofaProx' size='5.727 3.52 4.799'>");
  }

  @Test
  void thePlainSceneIsTheOtherWithoutItsMetadata() {
    String plain = text("scenes/apartment-plain.x3d");
    List<String> kept =
        text("scenes/apartment.x3d")
            .lines()
            .filter(line -> !line.contains("Metadata"))
            .filter(line -> !line.contains("ProximitySensor"))
            .filter(line -> !line.contains("<meta "))
            .toList();

    assertThat(plain).doesNotContain("Metadata");
    assertThat(
            plain
                .lines()
                .filter(l -> !l.contains("ProximitySensor"))
                .filter(l -> !l.contains("<meta ")))
        .containsExactlyElementsOf(kept);
  }

  @Test
  void everyDefIsUnique() {
    Set<String> seen = new HashSet<>();
    var matcher =
        java.util.regex.Pattern.compile("DEF='([^']*)'").matcher(text("scenes/apartment.x3d"));
    while (matcher.find()) {
      assertThat(seen.add(matcher.group(1))).as(matcher.group(1)).isTrue();
    }
    assertThat(seen)
        .contains("Kitchen", "Lounge", "Office", "Switch_TrashCan", "KitchenView", "KitchenMiddle");
  }

  /** The eye's way keeps a shoulder's width from walls and from what is as high as the chest. */
  @Test
  void theTourWalksThroughDoorsAndBesideTheFurniture() {
    List<double[]> eyes = new ArrayList<>();
    text("scenes/paths/apartment-tour.csv")
        .lines()
        .skip(1)
        .forEach(
            line -> {
              String[] words = line.split(",");
              eyes.add(new double[] {Double.parseDouble(words[1]), Double.parseDouble(words[3])});
            });
    WalkableArea space = new WalkableArea(apartment.placed());
    for (int i = 0; i + 1 < eyes.size(); i++) {
      for (int step = 0; step <= 50; step++) {
        double x = eyes.get(i)[0] + (eyes.get(i + 1)[0] - eyes.get(i)[0]) * step / 50;
        double z = eyes.get(i)[1] + (eyes.get(i + 1)[1] - eyes.get(i)[1]) * step / 50;
        assertThat(space.isFree(x, z)).as("%.2f %.2f", x, z).isTrue();
      }
    }
  }

  @Test
  void theFilesAreSmallEnoughToKeep() {
    long bytes = apartment.texts().values().stream().mapToLong(String::length).sum();
    assertThat(bytes / 1e6).isLessThan(40);
  }

  @Test
  void theTrashCanHasThePolygonsOfTheThesissExample() {
    assertThat(polygons.get("trashCan_v1.x3d")).isEqualTo(1064);
  }

  private String text(String path) {
    return apartment.texts().get(path);
  }
}
