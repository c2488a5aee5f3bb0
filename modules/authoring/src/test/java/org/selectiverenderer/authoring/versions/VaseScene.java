package org.selectiverenderer.authoring.versions;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.models.Model;
import org.selectiverenderer.models.ModelReader;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/** A scene of a vase on a table, and versions made of the vase. */
abstract class VaseScene {
  static final String SCENE =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D 3.3//EN" "http://www.web3d.org/specifications/x3d-3.3.dtd">
      <X3D profile='Immersive'   version="3.3">
        <!-- Größe > 1 && 'quotes' -->
        <Scene>
          <Transform DEF='Table' translation='1 2 3' >
            <!-- the vase -->
            <Shape   DEF='Vase'>
              <Appearance DEF='Red'><Material diffuseColor="1 0 0"/></Appearance>
              <Sphere radius='.5'/>
            </Shape>
            <TouchSensor DEF='Touch'/>
          </Transform >
        </Scene>
      </X3D>
      """;

  static final String CHANGED =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D 3.3//EN" "http://www.web3d.org/specifications/x3d-3.3.dtd">
      <X3D profile='Immersive'   version="3.3">
        <!-- Größe > 1 && 'quotes' -->
        <Scene>
          <Transform DEF='Table' translation='1 2 3' >
            <!-- the vase -->
            <Switch DEF='Switch_Vase' whichChoice='0'>
              <Inline DEF='Inline_Vase_v1' url='"inlineNodes/Vase_v1.x3d"'/>
              <Inline DEF='Inline_Vase_v2' url='"inlineNodes/Vase_v2.x3d"'/>
              <Inline DEF='Inline_Vase_v3' url='"inlineNodes/Vase_v3.x3d"'/>
            </Switch>
            <TouchSensor DEF='Touch'/>
          </Transform >
        </Scene>
      </X3D>
      """;

  static final List<SimplificationTarget> GOALS =
      List.of(
          new SimplificationTarget.VertexPercent(50), new SimplificationTarget.VertexPercent(10));

  @TempDir Path folder;

  final ProblemCollector problems = new ProblemCollector();
  final NodeCatalogue catalogue = NodeCatalogue.load();

  Path scene(byte[] bytes) throws IOException {
    return Files.write(folder.resolve("scene.x3d"), bytes);
  }

  Path scene(String text) throws IOException {
    return scene(text.getBytes(UTF_8));
  }

  Optional<VersionsEdit> plan(Path scene, String object, SimplificationTarget... goals)
      throws IOException {
    return plan(new VersionsEdit.Request(scene, object, List.of(goals), "inlineNodes"));
  }

  Optional<VersionsEdit> plan(VersionsEdit.Request request) throws IOException {
    return VersionsEdit.plan(
        DocumentFile.open(request.scene()).document().snapshot(), request, catalogue, problems);
  }

  VersionsEdit make(Path scene, String object, SimplificationTarget... goals) throws IOException {
    VersionsEdit plan = plan(scene, object, goals).orElseThrow();
    plan.write();
    return plan;
  }

  VersionsEdit make(Path scene, String object) throws IOException {
    return make(scene, object, GOALS.toArray(SimplificationTarget[]::new));
  }

  int polygons(String file) throws IOException {
    Optional<Model> model =
        new ModelReader(catalogue).read(folder.resolve(file), new ProblemCollector());
    return model.orElseThrow().polygons();
  }

  /** All files with their contents. */
  Map<Path, String> files() throws IOException {
    Map<Path, String> contents = new TreeMap<>();
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        contents.put(file, Files.readString(file, ISO_8859_1));
      }
    }
    return contents;
  }

  static String shape(String def, String geometry) {
    return "  <Shape DEF='" + def + "'>" + geometry + "</Shape>\n";
  }

  Path other(String name, String content) throws IOException {
    return Files.writeString(
        folder.resolve(name), "<X3D version='3.3'><Scene>\n" + content + "</Scene></X3D>\n");
  }
}
