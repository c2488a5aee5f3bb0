package org.selectiverenderer.browser.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.browser.scene.Node;

/** Scripts that change values of fields in place: elements of arrays, components, pixels. */
class ChangesInPlaceTest {
  /** More elements than could be changed in a call while each change copied the whole array. */
  private static final int MANY = 100_000;

  /** The memory is what a call has by default in a heap of 512 MB. */
  private static final ScriptLimits LIMITS = ScriptFixture.countedLimits(30, 30, 128 << 20);

  /**
   * A Script S with fields of its own and nodes that it may change, and a Script that counts the
   * events that the nodes send.
   */
  private static final String SCENE =
      """
      <Group DEF='G'>
        <Transform DEF='T1'/><Transform DEF='T2'/><Switch DEF='W'/>
        <Shape><Appearance><PixelTexture DEF='P' image='2 1 1 7 8'/></Appearance>
        <IndexedFaceSet DEF='F' coordIndex='0 1 0 -1'>
          <Coordinate DEF='C' point='1 2 3, 4 5 6'/></IndexedFaceSet></Shape>
      </Group>
      <Script DEF='S' directOutput='true'>
        <field name='go' type='SFInt32' accessType='inputOnly'/>
        <field name='out' type='SFString' accessType='outputOnly'/>
        <field name='points' type='MFVec3f' accessType='inputOutput' value='1 2 3, 4 5 6'/>
        <field name='exact' type='MFVec3d' accessType='inputOutput' value='1 2 3, 4 5 6'/>
        <field name='turns' type='MFRotation' accessType='inputOutput'/>
        <field name='numbers' type='MFFloat' accessType='inputOutput'/>
        <field name='doubles' type='MFDouble' accessType='inputOutput'/>
        <field name='counts' type='MFInt32' accessType='inputOutput'/>
        <field name='flags' type='MFBool' accessType='inputOutput'/>
        <field name='words' type='MFString' accessType='inputOutput'/>
        <field name='images' type='MFImage' accessType='inputOutput'/>
        <field name='fixed' type='MFFloat' accessType='initializeOnly' value='1 2'/>
        <field name='g' type='SFNode' accessType='initializeOnly'><Group USE='G'/></field>
        <field name='c' type='SFNode' accessType='initializeOnly'><Coordinate USE='C'/></field>
        <field name='f' type='SFNode' accessType='initializeOnly'><IndexedFaceSet USE='F'/></field>
        <field name='p' type='SFNode' accessType='initializeOnly'><PixelTexture USE='P'/></field>
        <field name='self' type='SFNode' accessType='initializeOnly'><Script USE='S'/></field>
        <![CDATA[ecmascript:
        function attempt(f) { try { return f(); } catch (e) { return e.name; } }
        %s
        ]]>
      </Script>
      <Script DEF='Counter'>
        <field name='point' type='MFVec3f' accessType='inputOnly'/>
        <field name='moved' type='SFVec3f' accessType='inputOnly'/>
        <field name='events' type='SFInt32' accessType='outputOnly'/>
        <field name='moves' type='SFInt32' accessType='outputOnly'/>
        <![CDATA[ecmascript:
        function point() { events++; }
        function moved() { moves++; }
        ]]>
      </Script>
      <ROUTE fromNode='C' fromField='point' toNode='Counter' toField='point'/>
      <ROUTE fromNode='T2' fromField='translation' toNode='Counter' toField='moved'/>
      """;

  private static ScriptFixture gone(String program) throws IOException {
    ScriptFixture scene = scene(program);
    scene.go(MANY);
    return scene;
  }

  private static ScriptFixture scene(String program) throws IOException {
    return new ScriptFixture(SCENE.formatted(program), LIMITS);
  }

  private static float[] ramp(int count) {
    float[] ramp = new float[3 * count];
    for (int i = 0; i < count; i++) {
      ramp[3 * i] = i;
    }
    return ramp;
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "c.point[i] = new SFVec3f(i, 0, 0);",
        "c.point[c.point.length == i ? i : i] = new SFVec3f(i, 0, 0);",
        "if (i == 0) c.point.length = 0; c.point[c.point.length] = new SFVec3f(i, 0, 0);",
        "c.point[i] = [i, 0, 0];",
        "c.point[i].x = i; c.point[i].y = 0; c.point[i].z = 0;",
        "c.point[i] = new SFVec3f(0, 0, 0); c.point[i][0] = i;",
        "if (i == 0) c.point = []; c.point.push(new SFVec3f(i, 0, 0));",
        "if (i == 0) c.point.length = n; c.point[i].setValue ? 0 : c.point[i] = new SFVec3f(i, 0, 0);"
      })
  void allElementsOfANodesArrayAreWrittenInOneCall(String statement) throws IOException {
    try (ScriptFixture scene =
        gone("function go(n) { for (var i = 0; i < n; i++) { %s } }".formatted(statement))) {
      assertThat(scene.told()).isEmpty();
      assertThat(scene.value("C", "point")).isEqualTo(ramp(MANY));
      assertThat(scene.value("Counter", "events")).isEqualTo(1);
    }
  }

  @Test
  void allElementsOfANodesArrayAreReadAndWrittenInOneCall() throws IOException {
    String program =
        """
        function go(n) {
          var sum = 0;
          c.point.length = n;
          for (var i = 0; i < n; i++) c.point[i].x = c.point[i].x + 1;
          for (var i = 0; i < n; i++) sum += c.point[i].x + c.point[i][1];
          out = '' + sum;
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.told()).isEmpty();
      assertThat(scene.out()).isEqualTo(Integer.toString(MANY + 1 + 4 + 2 + 5));
      assertThat(scene.value("Counter", "events")).isEqualTo(1);
    }
  }

  @Test
  void readingSendsNothing() throws IOException {
    try (ScriptFixture scene =
        gone(
            "function go(n) { for (var i = 0; i < n; i++) if (c.point[1].x + c.point[9].x != 4) throw i; out = c.point[1] + c.point[9]; }")) {
      assertThat(scene.told()).isEmpty();
      assertThat(scene.out()).isEqualTo("4 5 60 0 0");
      assertThat(scene.value("C", "point")).isEqualTo(new float[] {1, 2, 3, 4, 5, 6});
      assertThat(scene.value("Counter", "events")).isEqualTo(0);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          numbers | i / 2
          doubles | i / 2
          counts  | i
          flags   | i % 2 == 1
          words   | "w" + i
          """)
  void allElementsOfAScriptsOwnArraysAreReadAndWritten(String field, String value)
      throws IOException {
    String program =
        """
        function go(n) {
          for (var i = 0; i < n; i++) { FIELD[i] = VALUE; self.FIELD[i] = FIELD[i]; }
          for (var i = 0; i < n; i++) if (FIELD[i] != VALUE) throw i;
          FIELD[FIELD.length] = FIELD[7];
          out = FIELD.length + ' ' + FIELD[3] + ' ' + FIELD[n] + ' ' + FIELD[n + 1];
        }
        """
            .replace("FIELD", field)
            .replace("VALUE", value);
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.told()).isEmpty();
      String third = field.equals("flags") ? "true true" : "%s %s";
      assertThat(scene.out())
          .isEqualTo(
              (MANY + 1)
                  + " "
                  + switch (field) {
                    case "numbers", "doubles" -> "1.5 3.5";
                    case "counts" -> "3 7";
                    case "words" -> "w3 w7";
                    default -> third;
                  }
                  + " undefined");
    }
  }

  @Test
  void tuplesOfAllKindsAreElements() throws IOException {
    String program =
        """
        function go(n) {
          for (var i = 0; i < n; i++) { points[i].z = i; exact[i][2] = i; turns[i].angle = 1; }
          points[0] = exact[1];
          exact[n] = points[2];
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.told()).isEmpty();
      assertThat((float[]) scene.value("S", "points")).startsWith(4, 5, 1, 4, 5, 1, 0, 0, 2);
      assertThat((double[]) scene.value("S", "exact"))
          .hasSize(3 * MANY + 3)
          .startsWith(1, 2, 0, 4, 5, 1, 0, 0, 2)
          .endsWith(MANY - 1, 0, 0, 2);
      assertThat((float[]) scene.value("S", "turns"))
          .hasSize(4 * MANY)
          .startsWith(0, 0, 1, 1, 0, 0, 1, 1);
    }
  }

  @Test
  void imagesOfAnArrayAreChangedPixelByPixel() throws IOException {
    String program =
        """
        function go(n) {
          for (var i = 0; i < 300; i++) images[i] = new SFImage(1, 1, 1, new MFInt32(i));
          images[300].width = 250; images[300].height = 200; images[300].comp = 1;
          for (var i = 0; i < 50000; i++) images[300].array[i] = images[i % 300].array[0];
          out = images.length + ' ' + images[7].array[0] + ' ' + images[301].width;
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.told()).isEmpty();
      assertThat(scene.out()).isEqualTo("301 7 0");
      int[] images = (int[]) scene.value("S", "images");
      assertThat(images).hasSize(300 * 4 + 3 + 50_000).startsWith(1, 1, 1, 0, 1, 1, 1, 1);
      assertThat(Arrays.copyOfRange(images, 1200, 1205)).containsExactly(250, 200, 1, 0, 1);
    }
  }

  @Test
  void pixelsOfANodesImageAreChanged() throws IOException {
    String program =
        """
        function go(n) {
          p.image.width = 300;
          p.image.height = 300;
          for (var i = 0; i < 90000; i++) p.image.array[i] = i & 255;
          out = attempt(function () { p.image.width = 1e9; }) + ' ' + p.image.x;
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.told()).isEmpty();
      assertThat(scene.out()).isEqualTo("RangeError 300");
      assertThat((int[]) scene.value("P", "image")).hasSize(90_003).startsWith(300, 300, 1, 0, 1);
    }
  }

  @Test
  void fieldsOfChildrenAreChangedInPlace() throws IOException {
    String program =
        """
        function go(n) {
          for (var i = 0; i < n; i++) {
            g.children[1].translation.x = g.children[1].translation.x + 1;
          }
          g.children[0].rotation = new SFRotation(0, 1, 0, 1);
          g.children[0].rotation.angle = 2;
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.told()).isEmpty();
      assertThat(scene.value("T2", "translation")).isEqualTo(new float[] {MANY, 0, 0});
      assertThat(scene.value("T1", "rotation")).isEqualTo(new float[] {0, 1, 0, 2});
      assertThat(scene.value("Counter", "moves")).isEqualTo(1);
    }
  }

  @Test
  void nodesOfAnArrayAreReplacedAddedAndLeftOut() throws IOException {
    String program =
        """
        function go(n) {
          var t1 = g.children[0];
          g.children[0] = g.children[1];
          g.children[1] = t1;
          g.children[2] = NULL;
          g.children.length = 3;
          for (var i = 3; i < 2000; i++) g.children[g.children.length] = new SFNode('Group {}');
          out = attempt(function () { g.children[0] = c; })
              + ' ' + attempt(function () { f.coord = g; return 'done'; })
              + ' ' + (g.children[5000] === undefined) + ' ' + g.children[0].getNodeName();
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.told()).isEmpty();
      assertThat(scene.out()).isEqualTo("TypeError TypeError true T2");
      List<?> children = (List<?>) scene.value("G", "children");
      assertThat(children).hasSize(1999).doesNotContainNull();
      assertThat(children.subList(0, 2))
          .extracting(node -> ((Node) node).name())
          .containsExactly("T2", "T1");
    }
  }

  @Test
  void theLengthIsSet() throws IOException {
    String program =
        """
        function go(n) {
          turns.length = 3;
          turns.length = 1;
          turns.length = 2;
          turns[1].angle = 1;
          numbers = [1, 2, 3];
          numbers.length = 1;
          numbers.length = 3;
          words.length = 2;
          points.length = 0;
          c.point.length = 1;
          out = [attempt(function () { c.point.length = 1e9; }),
              attempt(function () { c.point.length = -1; }),
              attempt(function () { c.point[16777216] = new SFVec3f(); }),
              attempt(function () { c.point[1e8].x = 1; }), c.point.length].join(' ');
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.told()).isEmpty();
      assertThat(scene.out()).isEqualTo("RangeError RangeError RangeError TypeError 1");
      assertThat(scene.value("S", "turns")).isEqualTo(new float[] {0, 0, 1, 0, 0, 0, 1, 1});
      assertThat(scene.value("S", "numbers")).isEqualTo(new float[] {1, 0, 0});
      assertThat(scene.value("S", "words")).isEqualTo(new String[] {"", ""});
      assertThat(scene.value("S", "points")).isEqualTo(new float[0]);
      assertThat(scene.value("C", "point")).isEqualTo(new float[] {1, 2, 3});
    }
  }

  @Test
  void anElementThatIsReplacedOrLeavesKeepsItsValueAndIsItsOwn() throws IOException {
    String program =
        """
        function go(n) {
          var first = points[0];
          points[0] = points[1];
          points[1] = first;
          first.x = 100;
          var last = c.point.pop();
          last.x = 100;
          c.point.unshift(new SFVec3f(7, 8, 9));
          c.point.reverse();
          exact.reverse();
          exact.sort(function (a, b) { return a.x - b.x; });
          out = [first, last, points[0] === points[0]].join();
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.told()).isEmpty();
      assertThat(scene.out()).isEqualTo("100 2 3,100 5 6,true");
      assertThat(scene.value("S", "points")).isEqualTo(new float[] {4, 5, 6, 1, 2, 3});
      assertThat(scene.value("C", "point")).isEqualTo(new float[] {1, 2, 3, 7, 8, 9});
      assertThat(scene.value("S", "exact")).isEqualTo(new double[] {1, 2, 3, 4, 5, 6});
    }
  }

  @Test
  void oneFieldIsOneObjectWithinACall() throws IOException {
    String program =
        """
        function go(n) {
          var p = c.point;
          c.point[0].x = 10;
          p[1].x = 40;
          out = [p === c.point, p[0].x, c.point[1].x].join();
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.out()).isEqualTo("true,10,40");
      assertThat(scene.value("C", "point")).isEqualTo(new float[] {10, 2, 3, 40, 5, 6});
      assertThat(scene.value("Counter", "events")).isEqualTo(1);
    }
  }

  @Test
  void assignmentCopies() throws IOException {
    String program =
        """
        function go(n) {
          c.point = points;
          points[0].x = 10;
          var q = new MFVec3f(new SFVec3f(7, 7, 7));
          exact = q;
          q[0].x = 70;
          c.point[1].x = 40;
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.value("C", "point")).isEqualTo(new float[] {1, 2, 3, 40, 5, 6});
      assertThat(scene.value("S", "points")).isEqualTo(new float[] {10, 2, 3, 4, 5, 6});
      assertThat(scene.value("S", "exact")).isEqualTo(new double[] {7, 7, 7});
    }
  }

  @Test
  void anObjectThatAScriptKeepsChangesTheFieldInLaterCalls() throws IOException {
    String program =
        """
        var kept, own;
        function initialize() { kept = c.point; own = points; }
        function go(n) { kept[0].x = n; own[0].x = n; }
        """;
    try (ScriptFixture scene = scene(program)) {
      assertThat(scene.value("Counter", "events")).isEqualTo(0);
      scene.go(5);
      scene.go(6);

      assertThat(scene.told()).isEmpty();
      assertThat(scene.value("C", "point")).isEqualTo(new float[] {6, 2, 3, 4, 5, 6});
      assertThat(scene.value("S", "points")).isEqualTo(new float[] {6, 2, 3, 4, 5, 6});
      assertThat(scene.value("Counter", "events")).isEqualTo(2);
    }
  }

  @Test
  void aValueThatWasSentIsNotChangedByLaterCalls() throws IOException {
    try (ScriptFixture scene = scene("function go(n) { c.point[0].x = n; points[0].x = n; }")) {
      scene.go(5);
      Object sent = scene.value("C", "point");
      Object own = scene.value("S", "points");
      scene.go(6);

      assertThat(sent).isEqualTo(new float[] {5, 2, 3, 4, 5, 6});
      assertThat(own).isEqualTo(new float[] {5, 2, 3, 4, 5, 6});
      assertThat(scene.value("C", "point")).isEqualTo(new float[] {6, 2, 3, 4, 5, 6});
    }
  }

  @Test
  void indicesThatHaveAnEventToReplaceThemAreChangedByThatEvent() throws IOException {
    String program =
        """
        function go(n) {
          f.coordIndex = new MFInt32(2, 1);
          f.coordIndex[2] = 0;
          f.set_coordIndex[3] = -1;
          out = f.coordIndex.toString();
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.told()).isEmpty();
      assertThat(scene.out()).isEqualTo("[2, 1, 0, -1]");
      assertThat(scene.value("F", "coordIndex")).isEqualTo(new int[] {2, 1, 0, -1});
    }
  }

  @Test
  void whatAScriptMakesIsChangedInPlace() throws IOException {
    String program =
        """
        function go(n) {
          var made = Browser.currentScene.createNode('ElevationGrid');
          made.height.length = 2;
          made.height[1] = 5;
          made.xDimension = 2;
          made.height[0] = 4;
          out = made.toXMLString();
          g.children = [made];
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat((String) scene.out()).contains("4 5").contains("xDimension");
    }
  }

  @Test
  void aScriptsInitializeOnlyFieldIsNotWrittenThroughItsNode() throws IOException {
    String program =
        """
        function go(n) {
          fixed[0] = 9;
          out = attempt(function () { self.fixed[1] = 9; return 'done'; }) + ' ' + self.fixed;
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.out()).isEqualTo("TypeError [9, 2]");
      assertThat(scene.value("S", "fixed")).isEqualTo(new float[] {9, 2});
    }
  }

  @Test
  void whatWasChangedBeforeAFailureIsSent() throws IOException {
    try (ScriptFixture scene = gone("function go(n) { c.point[0].x = n; c.point[1] = 'no'; }")) {
      assertThat(scene.told()).singleElement().asString().contains("a value of type SFVec3f");
      assertThat(scene.value("C", "point")).isEqualTo(new float[] {MANY, 2, 3, 4, 5, 6});
      assertThat(scene.value("Counter", "events")).isEqualTo(1);
    }
  }

  @Test
  void arraysOfOtherTypesAndNestedListsAreConverted() throws IOException {
    String program =
        """
        function go(n) {
          exact = c.point;
          c.point = exact;
          numbers = new MFInt32(1, 2);
          doubles = numbers;
          out = attempt(function () { counts = words; return counts; }) + ' ' + new MFVec3f(points);
          points = [[1, 1, 1], new SFVec3d(2, 2, 2)];
        }
        """;
    try (ScriptFixture scene = gone(program)) {
      assertThat(scene.value("S", "exact")).isEqualTo(new double[] {1, 2, 3, 4, 5, 6});
      assertThat(scene.value("S", "points")).isEqualTo(new float[] {1, 1, 1, 2, 2, 2});
    }
  }
}
