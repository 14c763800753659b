# An X3D Script's one file: cmake -DOUT=loader.js -P bundle_loader.cmake; with -DWHICH=flyer that of /flyover.x3d.
# An X3D Script cannot import, so the modules are laid end to end without `import` lines and the word `export`, and
# what only people read is taken off (top-level names stay: X3D browsers call functions by them).
if(NOT ESBUILD)
  find_program(ESBUILD esbuild REQUIRED)
endif()
set(modules core/planGeometry.js core/sectorRecord.js core/recordMetadata.js core/loadPhase.js core/sectorSets.js
            core/tightBox.js core/GateTracker.js core/SectorFinder.js core/loadOrder.js core/LevelChoice.js
            core/GateImpostors.js core/Panoramas.js core/Doors.js core/SectorPlanner.js core/SectorLoader.js x3d/InlineSectors.js x3d/VrmlSectors.js x3d/loader.js)
if(WHICH STREQUAL flyer)
  set(modules core/readLayout.js core/groundTile.js core/prismTile.js core/triangulate.js core/TriangleBuilder.js core/prismMesh.js core/treeMesh.js
              core/groundMesh.js core/tileMesh.js core/blockMap.js core/indexedPicture.js core/blockMapTexture.js core/blockMapMesh.js core/tileLoad.js core/viewCone.js core/TileTree.js core/TileRequests.js
              core/TileFades.js core/RoofHeights.js core/Flyover.js core/TileShapes.js x3d/flyer.js)
endif()
set(bundle "")
foreach(module ${modules})
  file(READ ${CMAKE_CURRENT_LIST_DIR}/${module} text)
  string(REGEX REPLACE "(^|\n)import [^\n]*;" "\\1" text "${text}")
  string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
  string(APPEND bundle "${text}")
endforeach()
file(WRITE ${OUT} "${bundle}")
execute_process(COMMAND ${ESBUILD} ${OUT} --minify-whitespace --minify-syntax --target=es2022 --log-level=warning
                        "--banner:js=/* Vicus, MIT licence. As written: /client/x3d/ and /client/core/. */" --allow-overwrite --outfile=${OUT}
                RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "esbuild could not read ${OUT}")
endif()
