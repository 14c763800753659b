# The pages' programs and looks, few files for the web: cmake -DOUT=FOLDER [-DESBUILD=PROGRAM] -P bundle_page.cmake
#   main.js       the page; flightParts.js and tileWorker.js come when somebody flies, part-*.js is what those two share
#   x3domMain.js  the page for X3DOM
#   page.css      the page's looks
# The modules themselves are served, too, for who wants to read or use them.
if(NOT ESBUILD)
  find_program(ESBUILD esbuild REQUIRED)
endif()
set(common --bundle --minify --target=es2022 --log-level=warning
           "--banner:js=/* Vicus, MIT licence. The modules as written: /client/page/main.js and what it imports. */")

function(bundle)
  execute_process(COMMAND ${ESBUILD} ${ARGV} ${common} WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR}/page RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "esbuild could not bundle ${ARGV}")
  endif()
endfunction()

file(REMOVE_RECURSE ${OUT})
bundle(main.js flightParts.js tileWorker.js --format=esm --splitting --entry-names=[name] --chunk-names=part-[hash] --outdir=${OUT})
bundle(x3domMain.js --format=esm --outfile=${OUT}/x3domMain.js)
bundle(style.css --outfile=${OUT}/page.css)
