package org.selectiverenderer.render.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/**
 * A picture of which only the changed part is drawn is the one that is drawn as a whole. A part is
 * drawn with the samples of the picture before, a whole picture with those that are asked for: so
 * the pictures tell which it was.
 */
@RequiresDisplay
class PictureDamageTest {
  private static final int WIDTH = 200;
  private static final int HEIGHT = 150;
  private static final int SMOOTH = 4;

  private final ProblemCollector problems = new ProblemCollector();
  private final SceneLoader loader =
      new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems);
  private ScenePreviewRenderer view;
  private World world;

  @BeforeEach
  void open() throws IOException {
    view = ScenePreviewRenderer.open();
    StringBuilder scene = new StringBuilder("<X3D version='4.0'><Scene>");
    scene.append("<Viewpoint position='0 0 20'/>");
    scene.append("<Background skyColor='0 0 .3 .5 .6 1' skyAngle='3'/>");
    scene.append("<PointLight DEF='Lamp' location='0 5 5' on='true' intensity='.5'/>");
    for (int i = 0; i < 30; i++) {
      scene.append(
          """
          <Switch DEF='Choice_%d' whichChoice='0'>
          <Transform DEF='Place_%d' translation='%d %d %d'><Shape><Appearance>
          <Material DEF='Material_%d' diffuseColor='.8 .%d .2' transparency='%s'/></Appearance>
          %s</Shape></Transform></Switch>
          """
              .formatted(
                  i,
                  i,
                  2 * (i % 6) - 5,
                  2 * (i / 6) - 4,
                  i % 3,
                  i,
                  i % 10,
                  i % 4 == 0 ? ".5" : "0",
                  i % 2 == 0 ? "<Box/>" : "<Sphere/>"));
    }
    scene.append("<Transform translation='0 0 -5'><Shape><IndexedLineSet coordIndex='0 1 -1'>");
    scene.append("<Coordinate point='-9 -9 0 9 9 0'/></IndexedLineSet></Shape></Transform>");
    byte[] bytes = scene.append("</Scene></X3D>").toString().getBytes(StandardCharsets.UTF_8);
    world = new World(loader.load("test", new ByteArrayInputStream(bytes), Path.of("")), problems);
    step();
    assertThat(problems.list()).isEmpty();
  }

  @AfterEach
  void close() {
    view.close();
    loader.close();
  }

  private void step() {
    world.instances().update();
    world.step(0, (viewer, now, dt) -> {});
  }

  private Node node(String def) {
    return world.scene().find(def).orElseThrow();
  }

  private void set(String def, String field, Object value) {
    world.cascade().send(node(def), node(def).type().indexOf(field), value);
    world.cascade().run();
    step();
  }

  private Set<ShapeInstance> shapesOf(String def) {
    Set<ShapeInstance> shapes = new HashSet<>();
    for (ShapeInstance shape : world.instances().shapes()) {
      for (var at = shape.parent(); at != null; at = at.parent()) {
        if (at.node() == node(def)) {
          shapes.add(shape);
        }
      }
    }
    return shapes;
  }

  private static PreviewOptions masked(Set<ShapeInstance> shapes) {
    return new PreviewOptions(List.of(), shapes, false, Optional.empty());
  }

  private PreviewImage first(PreviewOptions options) {
    return view.draw(world, options, WIDTH, HEIGHT, SMOOTH);
  }

  /** The pixels in which two pictures differ but for rounding: column, row, most difference. */
  private static List<String> differing(PreviewImage one, PreviewImage other) {
    byte[] a = one.pixels().rgba();
    byte[] b = other.pixels().rgba();
    List<String> differing = new ArrayList<>();
    for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
      int most = 0;
      for (int i = 4 * pixel; i < 4 * pixel + 4; i++) {
        most = Math.max(most, Math.abs((a[i] & 0xff) - (b[i] & 0xff)));
      }
      if (most > 1) {
        differing.add(pixel % WIDTH + " " + pixel / WIDTH + ": " + most);
      }
    }
    return differing;
  }

  /** Draws what has changed and then all; returns whether the former was a part. */
  private boolean partLikeWhole(PreviewOptions options) {
    PreviewImage part = view.redraw(world, options, WIDTH, HEIGHT, 0);
    boolean inPart = part.samples() == SMOOTH;
    PreviewImage whole = view.draw(world, options, WIDTH, HEIGHT, inPart ? SMOOTH : 0);
    assertThat(differing(part, whole)).isEmpty();
    assertThat(part.drawn()).isEqualTo(whole.drawn());
    return inPart;
  }

  @Test
  void aShapeThatMoves() {
    first(PreviewOptions.NONE);
    set("Place_8", "translation", new float[] {-1.3f, -1.8f, 2.2f});

    assertThat(partLikeWhole(PreviewOptions.NONE)).isTrue();
  }

  @Test
  void aShapeOfAnotherColourBehindATransparentOne() {
    first(PreviewOptions.NONE);
    set("Material_13", "diffuseColor", new float[] {0, 1, 0});
    assertThat(partLikeWhole(PreviewOptions.NONE)).isTrue();

    set("Material_12", "transparency", 0.2f);
    assertThat(partLikeWhole(PreviewOptions.NONE)).isTrue();
  }

  @Test
  void aShapeThatGoesAndComes() {
    first(PreviewOptions.NONE);
    set("Choice_15", "whichChoice", -1);
    assertThat(partLikeWhole(PreviewOptions.NONE)).isTrue();

    set("Choice_15", "whichChoice", 0);
    assertThat(partLikeWhole(PreviewOptions.NONE)).isTrue();
  }

  @Test
  void anotherSelection() {
    first(masked(shapesOf("Place_0")));

    assertThat(partLikeWhole(masked(shapesOf("Place_29")))).isTrue();
  }

  @Test
  void aBoxAroundAShape() {
    first(PreviewOptions.NONE);
    Matrix4d place = new Matrix4d().translation(1.1, 0.07, 1).scale(2.5);
    BoxOverlay box = new BoxOverlay(place, new float[] {1, 0, 0, 1}, new float[] {1, 0, 0, .2f});
    PreviewOptions boxed = new PreviewOptions(List.of(box), Set.of(), false, Optional.empty());

    assertThat(partLikeWhole(boxed)).isTrue();
    assertThat(partLikeWhole(PreviewOptions.NONE)).isTrue();
  }

  @Test
  void nothing() {
    first(PreviewOptions.NONE);

    assertThat(partLikeWhole(PreviewOptions.NONE)).isTrue();
  }

  @Test
  void aLightChangesAll() {
    first(PreviewOptions.NONE);
    set("Lamp", "intensity", 1f);
    assertThat(partLikeWhole(PreviewOptions.NONE)).isFalse();
  }

  @Test
  void anotherViewOrSizeOrWireframeIsAnotherPicture() {
    first(PreviewOptions.NONE);
    world.step(0, (viewer, now, dt) -> viewer.moveTo(new Vector3d(0, 0, 19)));
    assertThat(partLikeWhole(PreviewOptions.NONE)).isFalse();

    first(PreviewOptions.NONE);
    PreviewOptions edges = new PreviewOptions(List.of(), Set.of(), true, Optional.empty());
    assertThat(partLikeWhole(edges)).isFalse();
    assertThat(partLikeWhole(PreviewOptions.NONE)).isFalse();

    first(PreviewOptions.NONE);
    assertThat(view.redraw(world, PreviewOptions.NONE, WIDTH, HEIGHT - 1, 0).samples()).isZero();
  }

  @Test
  void aPictureWithFewerSamplesIsNotAPartOfASmoothOne() {
    view.draw(world, PreviewOptions.NONE, WIDTH, HEIGHT, 0);

    PreviewImage smooth = view.redraw(world, PreviewOptions.NONE, WIDTH, HEIGHT, SMOOTH);

    assertThat(smooth.samples()).isEqualTo(SMOOTH);
    assertThat(differing(smooth, view.draw(world, PreviewOptions.NONE, WIDTH, HEIGHT, SMOOTH)))
        .isEmpty();
  }
}
