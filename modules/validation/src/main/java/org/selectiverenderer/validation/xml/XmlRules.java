package org.selectiverenderer.validation.xml;

import java.util.List;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;

/** Declares the rules SR000 to SR099, about the file and its XML. */
public final class XmlRules {
  static final Rule NOT_WELL_FORMED =
      Rule.error("SR001", "{fault}")
          .about("the XML, VRML or JSON is not well formed")
          .because(
              """
              Most programs refuse a file that is not well formed. This program keeps \
              the part before the error; all other findings of the file refer to that part.""")
          .bad("<Group><Shape></Group>")
          .good("<Group><Shape/></Group>")
          .see("XML 1.0, 2.1");

  static final Rule NO_X3D =
      Rule.error("SR002", "{fault}")
          .about("the file is not in an X3D encoding that this program reads")
          .because(
              """
              X3D in XML, ClassicVRML and JSON is read, as are VRML97 and VRML 1.0. Scenes of Open \
              Inventor can be converted, for example by view3dscene.""")
          .bad("#Inventor V2.1 ascii\nSeparator { Cube { } }")
          .good(
              "<?xml version='1.0' encoding='UTF-8'?>\n<X3D profile='Immersive' version='4.0'>\n"
                  + "  <Scene><Shape><Box/></Shape></Scene>\n</X3D>")
          .see("ISO/IEC 19776-1 (X3D XML encoding)");

  static final Rule COMPRESSION =
      Rule.error("SR003", "{fault}")
          .about("the compression is damaged")
          .because(
              """
              The compressed data end too early, usually after an interrupted download or a \
              text-mode transfer. Compress the original again.""")
          .bad("(the first half of scene.x3dz)")
          .good("(all of scene.x3dz)")
          .see("RFC 1952");

  static final Rule ENCODING =
      Rule.error("SR004", "{fault}")
          .about("the bytes do not fit the encoding that the file names")
          .because(
              """
              Other programs refuse a file whose bytes do not fit the encoding of its first \
              line (UTF-8 if it names none), or show other letters. Save it as UTF-8.""")
          .bad("<?xml version='1.0' encoding='UTF-8'?>  (and an e with acute as the one byte E9)")
          .good("<?xml version='1.0' encoding='UTF-8'?>  (and an e with acute as the bytes C3 A9)")
          .see("XML 1.0, 4.3.3");

  static final Rule ENTITY =
      Rule.error("SR005", "{fault}")
          .about("an entity that is not declared in the file itself or cannot be expanded")
          .because(
              """
              Entities that a file declares in its own DOCTYPE are expanded, within limits against \
              exhausting memory. External entities and DTDs are never read, since they are a way to \
              read other files, and many browsers expand no entities at all but &lt; &gt; &amp; \
              &quot; &apos; and numbers.""")
          .bad("<Text string='\"&copyright;\"'/>")
          .good("<Text string='\"&#169;\"'/>")
          .see("XML 1.0, 4.1");

  static final Rule DOCTYPE =
      Rule.warning("SR006", "the DOCTYPE is that of X3D {declared}, but the version is {version}")
          .because(
              """
              Programs that check against the DOCTYPE refuse what a later version added. A \
              DOCTYPE is optional; remove or update it.""")
          .bad(
              """
              <?xml version='1.0' encoding='UTF-8'?>
              <!DOCTYPE X3D PUBLIC 'ISO//Web3D//DTD X3D 3.3//EN' \
              'https://www.web3d.org/specifications/x3d-3.3.dtd'>
              <X3D profile='Immersive' version='4.0'><Scene/></X3D>""")
          .good(
              """
              <?xml version='1.0' encoding='UTF-8'?>
              <!DOCTYPE X3D PUBLIC 'ISO//Web3D//DTD X3D 4.0//EN' \
              'https://www.web3d.org/specifications/x3d-4.0.dtd'>
              <X3D profile='Immersive' version='4.0'><Scene/></X3D>""")
          .see("ISO/IEC 19776-1, 4.3.2");

  static final Rule ROOT =
      Rule.error("SR007", "the root element of a scene must be X3D, not {element}")
          .because("Nothing of such a file is shown; it may not be a scene at all.")
          .bad("<?xml version='1.0'?>\n<Scene><Shape><Box/></Shape></Scene>")
          .good(
              "<?xml version='1.0'?>\n<X3D profile='Immersive' version='4.0'>\n"
                  + "  <Scene><Shape><Box/></Shape></Scene>\n</X3D>")
          .see("ISO/IEC 19776-1, 4.3.3");

  static final Rule LIMIT =
      Rule.error("SR008", "{fault}; the rest of the file is not read")
          .about("the elements are too many or too deeply nested, or the entities too long")
          .because(
              """
              Limits keep a hostile file from using all memory. No real scene that we know \
              comes near them; the program that wrote this file probably has an error.""")
          .bad("(groups in groups, 300 deep)")
          .good("(groups in groups, 20 deep)")
          .see("docs/validate.md");

  static final Rule NAME_OF_COMPRESSED =
      Rule.warning("SR009", "the file is compressed, but its name ends in {ending}")
          .because(
              """
              Programs that rely on the name read the file as XML and fail. Name a \
              compressed scene .x3dz (or .x3d.gz).""")
          .bad("scene.x3d, beginning with the bytes 1F 8B")
          .good("scene.x3dz, beginning with the bytes 1F 8B")
          .see("ISO/IEC 19776-1, annex on MIME types and file extensions");

  static final Rule COMMENT =
      Rule.warning("SR010", "this comment suppresses nothing: {reason}")
          .because(
              """
              A comment 'validate-ignore ID ...' must be directly before its element and \
              name rules of the list.""")
          .bad("<!-- validate-ignore SR999 -->\n<Group/>")
          .good("<!-- validate-ignore SR114: on purpose -->\n<Group/>")
          .see("docs/validate.md");

  static final Rule TEXT =
      Rule.warning("SR011", "text between elements has no meaning in X3D: {text}")
          .because(
              """
              All values are attributes; text has a meaning only in scripts and shaders. \
              Often a comment has lost its marks, or an element its bracket.""")
          .bad("<Group>the table</Group>")
          .good("<Group><!-- the table --></Group>")
          .see("ISO/IEC 19776-1, 4.3");

  static final Rule MODEL =
      Rule.warning("SR012", "{fault}")
          .about("a part of a model or of a scene in VRML 1.0 that is left out")
          .because(
              """
              A model of another program, such as one in glTF, and a scene in VRML 1.0 are \
              translated into X3D when they are read. What X3D has no word for, or what the \
              translation does not read, is missing in the scene.""")
          .bad(
              """
              {"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_texture_basisu"]}""")
          .good(
              """
              {"asset": {"version": "2.0"}, "meshes": [{}], "nodes": [{"mesh": 0}]}""")
          .see("docs/models.md and docs/encodings.md");

  private XmlRules() {}

  /** The rules and their checks. */
  public static RuleGroup group() {
    return new RuleGroup(
        "XML and file",
        List.of(
            NOT_WELL_FORMED,
            NO_X3D,
            COMPRESSION,
            ENCODING,
            ENTITY,
            DOCTYPE,
            ROOT,
            LIMIT,
            NAME_OF_COMPRESSED,
            COMMENT,
            TEXT,
            MODEL),
        List.of(
            new ParseFaultCheck(),
            new PrologCheck(),
            new SuppressionCommentCheck(),
            new StrayTextCheck()),
        List.of());
  }
}
