package org.selectiverenderer.x3d.read;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.UrlResolver;

/** Libraries of prototypes in files, and a scene that names them. */
abstract class AbstractExternPrototypesTest {
  static final String LAMP =
      """
      <ProtoDeclare name='Lamp'>
        <ProtoInterface>
          <field name='at' type='SFVec3f' accessType='inputOutput' value='1 1 1'/>
          <field name='on' type='SFBool' accessType='inputOutput' value='true'/>
          <field name='shade' type='SFNode' accessType='initializeOnly'><Material DEF='Own'/></field>
        </ProtoInterface>
        <ProtoBody>
          <Transform><IS><connect nodeField='translation' protoField='at'/></IS>
            <PointLight><IS><connect nodeField='on' protoField='on'/></IS></PointLight>
            <Shape><Appearance><IS><connect nodeField='material' protoField='shade'/></IS>
              <ImageTexture url='"glow.png"'/></Appearance></Shape>
          </Transform>
        </ProtoBody>
      </ProtoDeclare>
      """;

  static final String RED =
      """
      <ProtoDeclare name='Red'>
        <ProtoBody><Material diffuseColor='1 0 0'/></ProtoBody>
      </ProtoDeclare>
      """;

  @TempDir Path folder;
  final ProblemCollector problems = new ProblemCollector();

  final X3dReader reader =
      new X3dReader(NodeCatalogue.load(), new ReadLimits(1 << 24, 1000, 100, 10_000));

  UrlResolver root;

  BaseUrl here;

  @BeforeEach
  void libraries() throws IOException {
    root = new UrlResolver(folder, ContentAccessPolicy.none());
    here = BaseUrl.folder(folder);
    write("lib/lamps.x3d", RED + LAMP);
  }

  void write(String name, String nodes) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text(nodes));
  }

  static String text(String nodes) {
    return "<X3D version='4.0' profile='Full'><Scene>\n" + nodes + "</Scene></X3D>";
  }

  X3dFile scene(String nodes) {
    return reader
        .with(new PrototypeLibraryLoader(reader, root), here)
        .read("test.x3d", text(nodes).getBytes(UTF_8), problems);
  }

  static String extern(String name, String url, String... fields) {
    return "<ExternProtoDeclare name='%s' url='%s'>%s</ExternProtoDeclare>\n"
        .formatted(name, url, String.join("", fields));
  }

  void assertTold(String... expected) {
    assertThat(problems.list())
        .extracting(
            problem ->
                problem.toString().replace(folder + File.separator, "").replace("lib\\", "lib/"))
        .containsExactly(expected);
  }
}
